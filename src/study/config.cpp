// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/config.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "glissade/core/units.hpp"

namespace glissade {

Quantities::Quantities() {
  const Case usual;
  for (const Parameter& p : parameters()) all_.push_back({{value_of(p, usual)}, {}});
}

const std::vector<double>& StudyConfig::thresholds_m() const {
  static const std::vector<double> none;
  return fragility ? fragility->thresholds_m : none;
}

bool StudyConfig::samples_friction() const {
  return std::ranges::find(friction.values, FrictionValue::as_drawn) != friction.values.end();
}

bool StudyConfig::draws() const {
  if (orientation.choice == OrientationChoice::random) return true;
  for (std::size_t i = 0; i < parameters().size(); ++i) {
    const bool is_mu =
        i == parameter_index("friction", "mu") || i == parameter_index("friction", "across_mu");
    if (quantities[i].is_drawn() && (samples_friction() || !is_mu)) return true;
  }
  return false;
}

bool StudyConfig::has_neighbours() const {
  return !quantities.at("friction", "neighbour_mu").is_always(0.0) ||
         !quantities.at("friction", "neighbour_over_mu").is_always(0.0);
}

std::string intensity_label(const IntensityConfig& intensity) {
  return fmt::format("{} ({})", intensity.measure.definition(intensity), intensity.measure.unit());
}

std::string describe(const Distribution& distribution) {
  struct Describe {
    std::string operator()(const Fixed& d) const { return fmt::format("{:g}", d.value); }
    std::string operator()(const Normal& d) const {
      return fmt::format("normal, mean {:.4g}, std {:.4g}", d.mean, d.std);
    }
    std::string operator()(const TruncatedNormal& d) const {
      std::string limits;
      if (std::isfinite(d.min)) limits += fmt::format(", not below {:g}", d.min);
      if (std::isfinite(d.max)) limits += fmt::format(", not above {:g}", d.max);
      return fmt::format("normal, mean {:.4g}, std {:.4g}{}", d.mean, d.std, limits);
    }
    std::string operator()(const LogNormal& d) const {
      return fmt::format("lognormal, median {:g}, log std {:g}", d.median, d.log_std);
    }
    std::string operator()(const Uniform& d) const {
      return fmt::format("uniform, {:g} to {:g}", d.min, d.max);
    }
    std::string operator()(const Triangular& d) const {
      return fmt::format("triangular, {:g}, {:g}, {:g}", d.min, d.mode, d.max);
    }
    std::string operator()(const Discrete& d) const {
      return fmt::format("one of {:g}", fmt::join(d.values, ", "));
    }
    std::string operator()(const Empirical& d) const {
      return fmt::format("empirical, {} values", d.values.size());
    }
  };
  return std::visit(Describe{}, distribution);
}

double slope_of_rise_deg(double rise) { return std::atan(rise / 12.0) / rad_per_deg; }

std::string describe(const Quantity& quantity) {
  if (!quantity.drawn) return fmt::format("{:g}", fmt::join(quantity.values, ", "));
  return (quantity.drawn_as_rise_in_12 ? "rise in 12 " : "") + describe(*quantity.drawn);
}

namespace {

/// Mean and standard deviation as the user states them: those of the parent where a normal is cut
/// at zero.
struct Moments {
  double mean, std;
};
Moments stated_moments(const Distribution& distribution) {
  if (const auto* cut = std::get_if<TruncatedNormal>(&distribution)) return {cut->mean, cut->std};
  return {mean(distribution), standard_deviation(distribution)};
}

}  // namespace

double stated_mean(const Distribution& distribution) { return stated_moments(distribution).mean; }

double stated_friction(const StudyConfig& config, const Case& c) {
  const bool is_across =
      c.orientation.slope_axis == SlopeAxis::n_s && config.friction.across_is_given;
  const Quantity& mu = config.quantities.at("friction", is_across ? "across_mu" : "mu");
  return mu.is_drawn() && c.friction_value == FrictionValue::as_drawn ? stated_mean(*mu.drawn)
                                                                      : c.friction;
}

double design_friction(const Distribution& mu) {
  const Moments moments = stated_moments(mu);
  return std::max(0.0, moments.mean - 2.0 * moments.std);
}

}  // namespace glissade
