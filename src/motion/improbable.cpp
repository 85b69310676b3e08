// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/motion/improbable.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "glissade/core/units.hpp"
#include "glissade/motion/intensity.hpp"
#include "glissade/motion/peak_names.hpp"

namespace glissade {
namespace {

/// Outside of it no recorded motion is known. `source` is that of the upper end; the lower ones are
/// recalled. IWTH25: 4,278 cm/s2 (Yamada et al. 2009).
struct RecordedRange {
  const char *what, *unit;  ///< of a peak what stands before its name
  double least, most;
  const char* source;
};

constexpr RecordedRange horizontal_pga{"", "g", 0.001, most_probable_pga_g,
                                       "largest horizontal: station MYG004, Tohoku 2011, 2.7 g"},
    vertical_pga{"vertical ", "g", 0.0, 4.0,
                 "largest: station IWTH25, Iwate-Miyagi 2008, 4.3 g of all components together"},
    pgv{"", "m/s", 0.0, 4.0, "largest: station TCU068, Chi-Chi 1999, 3.8 m/s (recalled)"},
    pgd{"", "m", 0.0, 10.0, "largest: station TCU068, Chi-Chi 1999, more than 9 m"},
    duration{"duration D5-95", "s", 0.5, 300.0, "recalled"},
    step{"time step", "s", 0.001, 0.05, "recalled: recorders take 20 to 1000 samples a second"};

/// Of the PGA of one horizontal component to that of the other; the largest of the records in
/// suites/ is 3.4.
constexpr double most_probable_pga_ratio = 4.0;

/// A paragraph of ASCE 7-16, 11.4.8 (recalled): sites where the mapped values and the site
/// coefficients are not enough, and the exception that is of them.
struct HazardAnalysisRule {
  char site_class;
  const char* mapped;
  double least_g;
  double DesignTarget::*value_g;
  int exception;
};
constexpr std::array hazard_analysis_rules{
    HazardAnalysisRule{'E', "S_S", 1.0, &DesignTarget::ss_g, 1},
    HazardAnalysisRule{'D', "S_1", 0.2, &DesignTarget::s1_g, 2},
    HazardAnalysisRule{'E', "S_1", 0.2, &DesignTarget::s1_g, 3}};

/// Those that apply to a site of mapped values.
std::vector<HazardAnalysisRule> rules_for(const DesignTarget& target) {
  std::vector<HazardAnalysisRule> found;
  if (target.edition != AsceEdition::asce7_16) return found;
  for (const SiteClass site : target.site_classes)
    for (const HazardAnalysisRule& rule : hazard_analysis_rules) {
      const bool is_of_class = site == SiteClass::unknown
                                   ? rule.site_class == 'D'
                                   : to_string(site) == std::string(1, rule.site_class);
      if (is_of_class && target.*rule.value_g >= rule.least_g) found.push_back(rule);
    }
  return found;
}

}  // namespace

std::vector<std::string> improbable_values(const Motion& motion, bool of_roof) {
  const PeakNames peak = peak_names(of_roof);
  std::vector<std::string> found = motion.contradictions;
  const auto check = [&](const RecordedRange& range, double value, const char* name = "") {
    if (value >= range.least && value <= range.most) return;
    const bool above = value > range.most;
    found.push_back(fmt::format("{}{} of {:.3g} {}, {} {:g} {} ({})", range.what, name, value,
                                range.unit, above ? "above" : "below",
                                above ? range.most : range.least, range.unit,
                                above ? range.source : "recalled"));
  };
  const auto& [first, second] = motion.horizontal_mps2;
  if (first == second) found.emplace_back("the same motion as both horizontal components");
  const auto check_signs = [&](const Samples& a, const char* component) {
    constexpr std::size_t least = 20;
    if (a.size() < least) return;
    const auto [low, high] = std::ranges::minmax_element(a);
    if (*low != *high && (*low >= 0.0 || *high <= 0.0))
      found.push_back(fmt::format(
          "no sample of its {} component is {} 0: an offset of the recorder, or a spectrum and no "
          "record",
          component, *low >= 0.0 ? "below" : "above"));
  };
  check_signs(first, "first");
  check_signs(second, "second");
  check_signs(motion.vertical_mps2, "vertical");
  if (!motion.vertical_mps2.empty() &&
      (motion.vertical_mps2 == first || motion.vertical_mps2 == second))
    found.emplace_back("the same motion as vertical and as horizontal component");
  if (!second.empty()) {
    const double one = peak_ground_acceleration_mps2(first),
                 other = peak_ground_acceleration_mps2(second);
    const double low = std::min(one, other), high = std::max(one, other);
    if (high > most_probable_pga_ratio * low)
      found.push_back(fmt::format(
          "{} of {:.3g} g and {:.3g} g along its two horizontal components, more than {:g} times "
          "each other: is one in another unit?",
          peak.acceleration, low / standard_gravity_mps2, high / standard_gravity_mps2,
          most_probable_pga_ratio));
  }
  constexpr double least_scale = 0.1, most_scale = 10.0;
  if (motion.scale < least_scale || motion.scale > most_scale)
    found.push_back(fmt::format(
        "a scale of {:.3g} in the suite file, outside {:g} to {:g}: so much weaker or stronger "
        "earthquakes have other durations and spectra; is it a conversion of units (units)?",
        motion.scale, least_scale, most_scale));
  const auto largest = [&](auto measure) {
    return second.empty() ? measure(first) : std::max(measure(first), measure(second));
  };
  const double dt_s = motion.dt_s;
  check(horizontal_pga, largest([](const auto& a) {
                          return peak_ground_acceleration_mps2(a);
                        }) / standard_gravity_mps2,
        peak.acceleration);
  check(vertical_pga, peak_ground_acceleration_mps2(motion.vertical_mps2) / standard_gravity_mps2,
        peak.acceleration);
  check(pgv, largest([&](const auto& a) { return peak_ground_velocity_mps(dt_s, a); }),
        peak.velocity);
  check(pgd, largest([&](const auto& a) { return peak_ground_displacement_m(dt_s, a); }),
        peak.displacement);
  check(duration, significant_duration_s(dt_s, first, second));
  check(step, dt_s);
  return found;
}

std::vector<std::string> notes_on(const Motion& motion) {
  std::vector<std::string> notes = motion.notes;
  notes.insert(notes.end(), motion.processing.begin(), motion.processing.end());
  if (motion.starts_are_assumed)
    notes.emplace_back(
        "components of different steps or lengths: they are assumed to start together");
  return notes;
}

std::string hazard_analysis_required(const DesignTarget& target) {
  const auto rules = rules_for(target);
  if (rules.empty()) return "";
  return fmt::format(
      "ASCE 7-16, 11.4.8, requires a ground motion hazard analysis of the site, or an exception, "
      "for site class {} with S_S {:g} g and S_1 {:g} g",
      rules.front().site_class, target.ss_g, target.s1_g);
}

std::string exceptions_text(const DesignTarget& target) {
  return fmt::format("exception{} {} of 11.4.8", target.exceptions.size() == 1 ? "" : "s",
                     fmt::join(target.exceptions, ", "));
}

bool takes_exception_2(const DesignTarget& target) {
  const auto is_2 = [](const HazardAnalysisRule& rule) { return rule.exception == 2; };
  return std::ranges::any_of(rules_for(target), is_2) &&
         std::ranges::count(target.exceptions, 2) > 0;
}

std::string unmet_hazard_analysis(const DesignTarget& target) {
  const auto rules = rules_for(target);
  if (rules.empty()) return "";
  const std::vector<int>& taken = target.exceptions;
  if (taken.empty()) return "not stated";
  const std::string stated = exceptions_text(target);
  for (const HazardAnalysisRule& rule : rules) {
    if (std::ranges::count(taken, rule.exception) > 0) continue;
    const HazardAnalysisRule& other =
        hazard_analysis_rules.at(static_cast<std::size_t>(taken.front() - 1));
    return fmt::format(
        "{}, which is of site class {} with {} of {:g} g or more: the site is of class {} with "
        "{} {:g} g, of exception {}",
        stated, other.site_class, other.mapped, other.least_g, rule.site_class, rule.mapped,
        target.*rule.value_g, rule.exception);
  }
  if (std::ranges::any_of(taken, [](int exception) { return exception != 2; }))
    return stated +
           ": exceptions 1 and 3 require F_a of class C, or the equivalent lateral force "
           "procedure, which this calculation does not have";
  return "";
}

std::vector<std::string> improbable_values(const DesignTarget& target) {
  std::vector<std::string> found;
  if (!target.is_mapped()) {
    const TargetSpectrum spectrum(target);
    if (spectrum.sds_g() > most_probable_g)
      found.push_back(
          fmt::format("S_DS of the target, {:g} g, is above {:g} g: no site is known for it",
                      spectrum.sds_g(), most_probable_g));
    if (spectrum.sd1_g() > spectrum.sds_g())
      found.push_back(fmt::format("S_D1 of the target, {:g} g, is above its S_DS, {:g} g",
                                  spectrum.sd1_g(), spectrum.sds_g()));
    return found;
  }
  if (target.s1_g > target.ss_g)
    found.push_back(fmt::format("S_1 of the target, {:g} g, is above its S_S, {:g} g", target.s1_g,
                                target.ss_g));
  if (target.ss_g > most_probable_g)
    found.push_back(
        fmt::format("S_S of the target, {:g} g, is above {:g} g: no site is known for it",
                    target.ss_g, most_probable_g));
  constexpr double longest_tl_s = 16.0;
  if (target.tl_s > longest_tl_s)
    found.push_back(
        fmt::format("T_L of {:g} s is above {:g} s, the longest that is mapped (recalled)",
                    target.tl_s, longest_tl_s));
  if (target.edition == AsceEdition::asce7_16 &&
      std::ranges::find(target.site_classes, SiteClass::b) != target.site_classes.end() &&
      target.site_classes.size() == 1)
    found.push_back(
        "site class B: F_a and F_v are those of a measured shear wave velocity; without one ASCE "
        "7-16, 11.4.3, requires 1.0, which is more");
  if (const std::string unmet = unmet_hazard_analysis(target); !unmet.empty())
    found.push_back(hazard_analysis_required(target) + "; hazard_analysis: " + unmet);
  return found;
}

std::string gaps_between(const std::vector<double>& periods_s) {
  std::vector<std::string> gaps;
  for (std::size_t i = 1; i < periods_s.size(); ++i) {
    if (periods_s[i] > widest_period_step * std::max(periods_s[i - 1], longest_rigid_period_s))
      gaps.push_back(fmt::format("{:g} and {:g}", periods_s[i - 1], periods_s[i]));
  }
  if (gaps.empty()) return "";
  return fmt::format(
      "between the building periods {} s nothing is computed, where the displacement may be "
      "larger: give periods at most {:g} times apart",
      fmt::join(gaps, ", "), widest_period_step);
}

std::string improbable_slope(double steepest_deg) {
  constexpr double least_drained_deg = 0.596;  // IBC 1507 (recalled)
  if (steepest_deg <= 0.0 || steepest_deg >= least_drained_deg) return "";
  return fmt::format(
      "a roof slope of {:g} degrees is flatter than 1/8 in 12, the least of a roof that drains: is "
      "it a rise in 12 (rise_in_12)?",
      steepest_deg);
}

std::string improbable_design_life(double years) {
  constexpr double longest_years = 200.0;
  if (years <= longest_years) return "";
  return fmt::format("a design life of {:g} years is longer than that of any building", years);
}

std::string unmarked_numbers(const std::vector<std::string>& numbers) {
  if (numbers.empty()) return "";
  const std::size_t shown = std::min<std::size_t>(numbers.size(), 4);
  const std::string more =
      numbers.size() > shown ? fmt::format(" and {} more", numbers.size() - shown) : "";
  return fmt::format(
      "without a unit in the file, read in m or kN although units = \"us\": {}{}; write for "
      "example \"30 ft\", \"18 in\", \"60 kip\"",
      fmt::join(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(shown), ", "), more);
}

std::string improbable_mce_rate(double annual_rate, const std::string& mce) {
  constexpr double shortest_years = 200.0, longest_years = 25000.0;
  const double years = 1.0 / annual_rate;
  if (years >= shortest_years && years <= longest_years) return "";
  return fmt::format(
      "the hazard curve gives {} once in {:.3g} years, where about 2,500 are usual: are its rates "
      "annual ones (not probabilities in 50 years), and its intensities in the unit of the levels?",
      mce, years);
}

}  // namespace glissade
