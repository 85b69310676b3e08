// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/design/premises.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>
#include <cstdio>
#include <string_view>

#include "glissade/design/design_clearance.hpp"
#include "glissade/motion/improbable.hpp"

namespace glissade {
namespace {

using Found = std::optional<Statement>;

const Statement not_stated{"not stated", false};

std::string lower_case(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

/// Neither empty nor a word that stands for nothing.
bool is_stated(const std::string& text) {
  const std::string words = lower_case(text);
  const auto is_blank = [](unsigned char c) { return std::isalnum(c) == 0 && c < 0x80; };
  const auto begins = [&](std::string_view word) {
    return words.starts_with(word) && (words.size() == word.size() || is_blank(words[word.size()]));
  };
  return !std::ranges::all_of(words, is_blank) &&
         std::ranges::none_of(
             std::array{"not stated", "not known", "none", "unknown", "n/a", "tbd", "to be"},
             begins);
}

/// As it is written where it stands for nothing.
Statement stated(const std::string& text) {
  return text.empty() ? not_stated : Statement{text, is_stated(text)};
}

/// A day of the calendar, "2026-10-14".
bool is_date(const std::string& text) {
  int year = 0, month = 0, day = 0, length = 0;
  constexpr std::size_t digits = 10;
  if (text.size() != digits ||
      std::sscanf(text.c_str(), "%4d-%2d-%2d%n", &year, &month, &day, &length) != 3)  // NOLINT
    return false;
  return length == static_cast<int>(digits) &&
         std::chrono::year_month_day(std::chrono::year(year),
                                     std::chrono::month(static_cast<unsigned>(month)),
                                     std::chrono::day(static_cast<unsigned>(day)))
             .ok();
}

/// No test or report is of a day after the calculation: project.date, or the day on which it is
/// made, whichever is earlier. The latter decides nothing else, so that outputs do not depend on
/// it.
Statement dated(const std::string& text, const Project& p) {
  if (!is_date(text)) return {stated(text).text, false};
  const bool is_of_project = is_date(p.title.date) && p.title.date <= p.read_on;
  const std::string& last = is_of_project ? p.title.date : p.read_on;
  if (text <= last) return {text, true};
  return {fmt::format("{}, after {}, the {}", text, last,
                      is_of_project ? "date of the calculation (project.date)"
                                    : "day of this calculation (UTC)"),
          false};
}

Found edition(const Project& p) {
  const AsceEdition of_standard =
      p.standard == Standard::asce7_16 ? AsceEdition::asce7_16 : AsceEdition::asce7_10;
  return Statement{fmt::format("{} with site values of {}",
                               p.standard == Standard::asce7_16 ? "ASCE 7-16" : "SEAOC PV1-2012",
                               edition_name(p.site.target.edition)),
                   p.site.target.edition == of_standard};
}

Found importance(const Project& p) {
  const double of_category = importance_factor(p.site.risk);
  return Statement{fmt::format("{:g}; {:g} of risk category {}", p.importance, of_category,
                               to_string(p.site.risk)),
                   p.importance >= of_category};
}

/// Of a spectrum that is compared with mapped values where it is not of an analysis.
Found hazard_analysis(const Project& p) {
  const DesignTarget& target = p.site.mapped.value_or(p.site.target);
  if (target.edition != AsceEdition::asce7_16 || p.site.is_of_analysis()) return {};
  if (hazard_analysis_required(target).empty()) return Statement{"not required", true};
  const std::string unmet = unmet_hazard_analysis(target);
  return Statement{unmet.empty() ? exceptions_text(target) : unmet, unmet.empty()};
}

Found analysis_report(const Project& p) {
  if (!p.site.is_of_analysis()) return {};
  Statement found = stated(p.site.analysis.report);
  if (!found.is_met && p.site.target.period_s.empty())
    found.text +=
        ", and S_S, S_1 and site class are not stated, by which 11.4.8 may require an analysis";
  return found;
}
Found analysis_author(const Project& p) {
  return p.site.is_of_analysis() ? Found(stated(p.site.analysis.author)) : Found();
}
Found analysis_date(const Project& p) {
  return p.site.is_of_analysis() ? Found(dated(p.site.analysis.date, p)) : Found();
}

Found mapped_beside_spectrum(const Project& p) {
  if (p.site.target.period_s.empty() || p.site.target.edition == AsceEdition::asce7_22) return {};
  return p.site.mapped ? Statement{to_string(*p.site.mapped), true} : not_stated;
}

Found fault_distance(const Project& p) {
  constexpr double near_fault_km = 15.0;
  if (!p.site.fault_distance_km) return not_stated;
  return Statement{fmt::format("{:g} km", *p.site.fault_distance_km),
                   *p.site.fault_distance_km >= near_fault_km};
}

Found diaphragm(const Project& p) {
  if (p.of_roof) return {};
  const std::string& found = p.building.diaphragm;
  return found.empty() ? not_stated : Statement{found, found == "rigid"};
}

/// A frequency, or the period of another building.
Found period(const Project& p) {
  constexpr double most_apart = 4.0;
  constexpr double of_storey_s = 0.1, of_hall_s = 0.25;  // ASCE 7-16, 12.8-8 (recalled); of 30 ft
  const ProjectBuilding& building = p.building;
  if (p.of_roof) return {};
  const auto range = [](double from_s, double to_s) {
    return from_s == to_s ? fmt::format("{:.3g} s", to_s)
                          : fmt::format("{:.3g} to {:.3g} s", from_s, to_s);
  };
  const double shortest_s = building.period_s.front(), longest_s = building.period_s.back();
  if (!building.approximate_period_s && !building.storeys)
    return Statement{range(shortest_s, longest_s) +
                         ", not checked: state storeys, or system and height_m in its place",
                     false};
  const double of_storeys_s = of_storey_s * building.storeys.value_or(1.0),
               low_s = building.approximate_period_s.value_or(of_storeys_s),
               high_s = building.approximate_period_s.value_or(std::max(of_storeys_s, of_hall_s));
  return Statement{
      fmt::format("{}, T_a {}{}", range(shortest_s, longest_s), range(low_s, high_s),
                  building.approximate_period_s ? "" : " (0.1 s for each storey, or a hall)"),
      shortest_s >= low_s / most_apart && longest_s <= most_apart * high_s};
}

Found source(const Project& p) { return stated(p.friction.report); }
Found laboratory(const Project& p) { return stated(p.friction.laboratory); }
Found tested_on(const Project& p) { return dated(p.friction.tested_on, p); }
Found surface(const Project& p) {
  return p.friction.surface.empty() ? not_stated : Statement{p.friction.surface_text(), true};
}

Found conditions(const Project& p) {
  const auto values = prescribed_values(p, site_values(p.site));
  const auto of = std::ranges::find(values, p.standard, &PrescribedValue::standard);
  return Statement{of->may_be_used() ? "all met" : of->not_met(), of->may_be_used()};
}

Found motions(const Project& p) {
  return p.simulated_motions ? Statement{"simulated, which does not serve for a permit", false}
                             : Statement{p.of_roof ? "of a roof" : "recorded", true};
}

Found scaling_rule(const Project& p) {
  if (p.of_roof) return {};
  const ScalingRuleText& rule = text_of(p.scaling_rule);
  return Statement{rule.clause, p.scaling_rule == ScalingRule::walters_2012 ||
                                    rule.key == to_string(p.site.target.edition)};
}

Found roof_report(const Project& p) { return p.of_roof ? Found(stated(p.roof.report)) : Found(); }
Found roof_author(const Project& p) { return p.of_roof ? Found(stated(p.roof.author)) : Found(); }
Found roof_date(const Project& p) { return p.of_roof ? Found(dated(p.roof.date, p)) : Found(); }

Found units(const Project& p) {
  const std::string unmarked = unmarked_numbers(p.unmarked_numbers);
  return unmarked.empty() ? Statement{"all with units", true} : Statement{unmarked, false};
}

constexpr const char* a_date = "a date, \"2026-10-14\", not after that of the calculation";

constexpr std::array rows{
    PremiseRow{"units of lengths and weights", "project.units",
               "each number in a US project with its unit", units},
    PremiseRow{"standard and site values", "standards.compare",
               "of one edition: ASCE 7-16, or SEAOC PV1-2012 with values of ASCE 7-10", edition},
    PremiseRow{"importance factor I_e", "standards.importance", "that of the risk category or more",
               importance},
    PremiseRow{"ground motion hazard analysis (ASCE 7-16, 11.4.8)", "site.hazard_analysis",
               "where S_S, S_1 and site class require it: a spectrum of an analysis, or the "
               "exception that is of the site class",
               hazard_analysis},
    PremiseRow{"report on the spectrum", "site.hazard_report", "its title and number",
               analysis_report},
    PremiseRow{"author of the spectrum", "site.hazard_author", "who made the analysis",
               analysis_author},
    PremiseRow{"date of the spectrum", "site.hazard_date", a_date, analysis_date},
    PremiseRow{"S_S, S_1 and site class beside the spectrum", "site.ss_g",
               "stated: the spectrum is 80 % of theirs or more (21.3)", mapped_beside_spectrum},
    PremiseRow{"distance to the nearest active fault", "site.fault_distance_km",
               "15 km or more: at less the standard requires records with pulses (ASCE 7-16, "
               "11.4.1, 16.2.2), which are not checked",
               fault_distance},
    PremiseRow{"roof diaphragm", "building.diaphragm",
               "rigid, as it is computed: at midspan of a flexible one the mean slip was 1.3 to "
               "2.3 times as large",
               diaphragm},
    PremiseRow{"building period", "building.period_s",
               "from a quarter of the approximate period T_a to 4 times it", period},
    PremiseRow{"source of the friction", "friction.source", "number of the test report", source},
    PremiseRow{"laboratory of the friction tests", "friction.laboratory", "its name", laboratory},
    PremiseRow{"date of the friction tests", "friction.tested_on", a_date, tested_on},
    PremiseRow{"surface of the friction tests", "friction.surface", "\"dry\", \"wet\" or \"both\"",
               surface},
    PremiseRow{"conditions of the standard", "array",
               "all met: else an unanchored array requires the approval of the authority",
               conditions},
    PremiseRow{"motions of the suite", "suite.file", "recorded, or of a roof", motions},
    PremiseRow{"rule of scaling", "suite.scaling_rule",
               "that of the site's edition of ASCE 7, or of Walters et al. (2012)", scaling_rule},
    PremiseRow{"report on the roof motions", "suite.report", "its title and number", roof_report},
    PremiseRow{"author of the roof motions", "suite.author", "who made or recorded them",
               roof_author},
    PremiseRow{"date of the roof motions", "suite.date", a_date, roof_date}};

}  // namespace

std::span<const PremiseRow> premise_rows() { return rows; }

std::vector<Premise> premises_of(const Project& project) {
  std::vector<Premise> found;
  for (const PremiseRow& row : rows)
    if (auto statement = row.find(project))
      found.push_back({row.what, row.key, row.required, *std::move(statement)});
  return found;
}

std::string not_met_text(const Premise& premise) {
  return fmt::format("{}: {}; required: {} ({})", premise.what, premise.found.text,
                     premise.required, premise.key);
}

bool is_of_premise(const Project& project, const std::string& warning) {
  const std::string of_11_4_8 = hazard_analysis_required(project.site.target);
  return !of_11_4_8.empty() && warning.starts_with(of_11_4_8);
}

}  // namespace glissade
