// SPDX-License-Identifier: GPL-3.0-or-later
#include "suite/conditional_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "glissade/core/error.hpp"
#include "glissade/motion/improbable.hpp"
#include "glissade/motion/simulation/bssa14.hpp"

namespace glissade::cli {
namespace {

constexpr double shortest_s = 0.01, longest_s = 10.0;  // of the correlations and of BSSA14
constexpr double in_95_percent = 1.959963984540054;

/// An option that must be there and within its range.
class RequiredOptions {
 public:
  double required(const std::optional<double>& value, const char* option, double low, double high,
                  const char* unit, const char* advice) {
    if (value && *value >= low && *value <= high) return *value;
    problems_.add(
        {option,
         value ? fmt::format("{:g}{} is not from {:g} to {:g}{}", *value, unit, low, high, unit)
               : "is missing",
         advice, ""});
    return low;
  }
  ProblemList& problems() { return problems_; }

 private:
  ProblemList problems_;
};

}  // namespace

void ConditionalOptions::add_to(CLI::App& command) {
  command.add_option("--period-s", period_s, "period of the known spectral acceleration");
  command.add_option("--sa-g", sa_g, "spectral acceleration at that period (RotD50, 5 %)");
  command.add_option("--epsilon", epsilon,
                     "in place of --sa-g: its standard deviations above the median");
  command.add_option("--magnitude", magnitude, "moment magnitude of the earthquake");
  command.add_option("--distance-km", distance_km, "Joyner-Boore distance");
  command.add_option("--vs30-mps", vs30_mps, "V_S30 of the site");
  command.add_option("--mechanism", mechanism, "strike_slip or reverse");
  command.add_option("--from-s", from_s, "shortest period of the spectrum [0.05, or 0.2 of it]");
  command.add_option("--to-s", to_s, "longest period of the spectrum [2, or twice it]");
}

bool ConditionalOptions::are_given() const {
  return period_s || sa_g || epsilon || magnitude || distance_km || vs30_mps || from_s || to_s;
}

ConditionalTarget ConditionalOptions::target() const {
  RequiredOptions options;
  const double t_s =
      options.required(period_s, "--period-s", shortest_s, longest_s, " s",
                       "give the period at which Sa is known: that of the building, as a rule");
  Scenario scenario{
      options.required(magnitude, "--magnitude", 3.0, 8.5, "",
                       "give that of the earthquake which governs, of a disaggregation"),
      options.required(distance_km, "--distance-km", 0.0, 400.0, " km",
                       "give that of the earthquake which governs, of a disaggregation"),
      options.required(vs30_mps, "--vs30-mps", 100.0, 2000.0, " m/s", "give that of the site")};
  if (mechanism == "reverse")
    scenario.mechanism = FaultMechanism::reverse;
  else if (mechanism != "strike_slip")
    options.problems().add(
        {"--mechanism", mechanism + " is not known", "give strike_slip or reverse", ""});
  if (sa_g && epsilon)
    options.problems().add(
        {"--epsilon", "is given beside --sa-g, from which it follows", "give one of them", ""});
  if (!epsilon)
    options.required(sa_g, "--sa-g", 1e-4, most_possible_g, " g",
                     "give the spectral acceleration at --period-s, or its --epsilon");
  else if (!(std::abs(*epsilon) <= 10.0))
    options.problems().add({"--epsilon", fmt::format("{:g} is not from -10 to 10", *epsilon),
                            "give the standard deviations above the median", ""});
  const double low_s = from_s.value_or(std::max(shortest_s, std::min(0.05, 0.2 * t_s))),
               high_s = to_s.value_or(std::min(longest_s, std::max(2.0, 2.0 * t_s)));
  if (!(low_s >= shortest_s && high_s <= longest_s && low_s < high_s && low_s <= t_s &&
        t_s <= high_s))
    options.problems().add(
        {"--from-s, --to-s",
         fmt::format("{:g} to {:g} s is no range from {:g} to {:g} s that contains --period-s",
                     low_s, high_s, shortest_s, longest_s),
         "give the periods at which the spectra matter", ""});
  options.problems().throw_if_any();

  constexpr std::size_t periods = 30;
  ConditionalTarget target;
  target.predicted = bssa14_spectrum(scenario, spectrum_periods_s(low_s, high_s, periods, t_s));
  const std::vector<double>& all_s = target.predicted.periods_s;
  target.period = static_cast<std::size_t>(std::ranges::find(all_s, t_s) - all_s.begin());
  target.sa_g = sa_g ? *sa_g : target.predicted.sa_g(target.period, *epsilon);
  target.spectrum = conditional_on(target.predicted, target.period, target.sa_g);
  return target;
}

std::string ConditionalOptions::sentence(const ConditionalTarget& target) const {
  return fmt::format(
      "conditional spectrum of Sa({:g} s) = {:.4g} g (RotD50), M {:g}, R_JB {:g} km, V_S30 {:g} "
      "m/s, {}: epsilon {:.3f} (BSSA14; correlation of Baker & Jayaram 2008)",
      target.period_s(), target.sa_g, *magnitude, *distance_km, *vs30_mps, mechanism,
      target.epsilon());
}

std::vector<std::string> ConditionalOptions::warnings(const ConditionalTarget& target) const {
  constexpr double most_probable = 3.0;
  std::vector<std::string> found = outside_bssa14({*magnitude, *distance_km, *vs30_mps});
  const double epsilon = target.epsilon();
  if (std::abs(epsilon) > most_probable)
    found.push_back(fmt::format(
        "Sa({:g} s) = {:.4g} g is {:.1f} standard deviations {} the median of this earthquake: "
        "take the earthquake that governs it, of a disaggregation",
        target.period_s(), target.sa_g, std::abs(epsilon), epsilon > 0.0 ? "above" : "below"));
  return found;
}

Table target_table(const ConditionalTarget& target) {
  Table table{"target",
              "",
              {{"period", "s", "Period, s"},
               {"predicted_median_sa", "g", "Median without it, g"},
               {"predicted_sigma", "", "Std of ln Sa without it"},
               {"correlation", "", "Correlation with the known Sa"},
               {"median_sa", "g", "Conditional mean, g"},
               {"sigma", "", "Conditional std of ln Sa"},
               {"p2_5_sa", "g", "2.5th percentile, g"},
               {"p97_5_sa", "g", "97.5th percentile, g"}},
              {}};
  for (std::size_t p = 0; p < target.spectrum.size(); ++p)
    table.add({target.spectrum.periods_s[p], target.predicted.sa_g(p), target.predicted.sigma(p),
               epsilon_correlation(target.spectrum.periods_s[p], target.period_s()),
               target.spectrum.sa_g(p), target.spectrum.sigma(p),
               target.spectrum.sa_g(p, -in_95_percent), target.spectrum.sa_g(p, in_95_percent)});
  return table;
}

}  // namespace glissade::cli
