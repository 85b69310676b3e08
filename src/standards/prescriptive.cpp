// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/standards/prescriptive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "glissade/core/error.hpp"
#include "glissade/core/units.hpp"

namespace glissade {
namespace {

constexpr std::array<const char*, 6> category_names = {"A", "B", "C", "D", "E", "F"};
constexpr double pv1_floor_m = 6.0 * inch_m;
constexpr double asce7_16_floor_m = 24.0 * inch_m;
constexpr double asce7_16_least_edge_m = 4.0 * foot_m;

void check_not_negative(const char* name, double value, const char* suggestion,
                        ProblemList& problems) {
  if (std::isfinite(value) && value >= 0.0) return;
  problems.add({"", fmt::format("{} = {} is not a number >= 0", name, value), suggestion, ""});
}

/// (S_DS - 0.4)^2, where S_DS below 0.4 counts as 0.4.
double demand(double sds_g) {
  const double over = std::max(0.0, sds_g - 0.4);
  return over * over;
}

/// The formula if it governs, else the lower bound.
Prescription not_less_than(const Prescription& floor, const Prescription& formula) {
  return formula.value_m >= floor.value_m ? formula : floor;
}

}  // namespace

std::string key_of(Standard standard) {
  return standard == Standard::seaoc_pv1_2012 ? "seaoc_pv1_2012" : "asce7_16";
}

SeismicDesignCategory parse_seismic_design_category(const std::string& text) {
  const auto found = std::ranges::find(category_names, text);
  if (found == category_names.end()) {
    throw InputError({"", fmt::format("\"{}\" is not a seismic design category", text),
                      "give one of A to F", ""});
  }
  return static_cast<SeismicDesignCategory>(found - category_names.begin());
}

std::string to_string(SeismicDesignCategory category) {
  return category_names[static_cast<std::size_t>(category)];
}

Prescription seaoc_pv1_2012_displacement(double sds_g, SeismicDesignCategory category) {
  ProblemList problems;
  check_not_negative("sds_g", sds_g, "give S_DS in g", problems);
  problems.throw_if_any();
  if (category < SeismicDesignCategory::d) {
    return {pv1_floor_m, Provenance::recalled,
            "SEAOC PV1-2012: 6 in for seismic design categories A to C"};
  }
  return not_less_than(
      {pv1_floor_m, Provenance::recalled, "SEAOC PV1-2012: not less than 6 in"},
      {60.0 * demand(sds_g) * inch_m, Provenance::checked, "SEAOC PV1-2012: 60 (S_DS - 0.4)^2 in"});
}

Prescription asce7_16_displacement(double sds_g, double importance) {
  ProblemList problems;
  check_not_negative("sds_g", sds_g, "give S_DS in g", problems);
  check_not_negative("importance", importance, "I_e is 1.0, 1.25 or 1.5", problems);
  problems.throw_if_any();
  return not_less_than(
      {asce7_16_floor_m, Provenance::recalled, "ASCE 7-16 section 13.6.12: not less than 24 in"},
      {5.0 * importance * demand(sds_g) * foot_m, Provenance::checked,
       "ASCE 7-16 section 13.6.12: 5 I_e (S_DS - 0.4)^2 ft"});
}

std::vector<Separation> separations_of(Standard standard, double displacement_m) {
  ProblemList problems;
  check_not_negative("displacement_m", displacement_m, "give the design displacement in metres",
                     problems);
  problems.throw_if_any();
  const bool pv1 = standard == Standard::seaoc_pv1_2012;
  // The factors of ASCE 7-16 are those of a stamped permit calculation.
  const Provenance of_factors = pv1 ? Provenance::recalled : Provenance::checked;
  const auto separation = [&](const char* what, double factor) {
    return Separation{what, factor, 0.0, factor * displacement_m, of_factors, ""};
  };
  std::vector<Separation> all{separation("between similar arrays", 0.5),
                              separation("to a fixed object or a different array", 1.0),
                              separation("to a roof edge with a qualifying parapet", 1.0),
                              separation("to a roof edge without a qualifying parapet", 2.0)};
  Separation& edge = all.back();
  if (pv1) return all;
  edge.least_m = asce7_16_least_edge_m;
  edge.basis = "and 4 ft or more";
  if (edge.value_m < edge.least_m) {
    edge.value_m = edge.least_m;
    edge.provenance = Provenance::recalled;
  }
  return all;
}

std::string qualifying_parapet(Standard standard) {
  return standard == Standard::seaoc_pv1_2012
             ? "A parapet qualifies that rises 6 in (0.15 m) or more above the centre of mass of "
               "the array and 24 in (0.61 m) or more above the roof (SEAOC PV1-2012)"
             : "A curb or parapet qualifies that rises 12 in (0.30 m) or more above the roof and "
               "is designed for a force of 0.2 S_DS times the weight of the array where it may "
               "strike (ASCE 7-16, 13.6.12)";
}

}  // namespace glissade
