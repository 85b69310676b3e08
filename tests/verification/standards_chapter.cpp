// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "chapters.hpp"
#include "glissade/core/units.hpp"
#include "glissade/motion/design_spectrum.hpp"
#include "glissade/standards/prescriptive.hpp"

namespace glissade::verification {
namespace {

using enum AsceEdition;
using enum SiteClass;

void add_displacements(std::vector<Case>& cases) {
  const std::string recalled = "recalled: verify against the standard";
  const auto seaoc_in = [](double sds_g, SeismicDesignCategory category) {
    return seaoc_pv1_2012_displacement(sds_g, category).value_m / inch_m;
  };
  const auto asce_in = [](double sds_g) {
    return asce7_16_displacement(sds_g, 1.0).value_m / inch_m;
  };
  cases.push_back(
      compare({"SEAOC PV1-2012, S_DS 1.566 g, SDC D", "displacement, in",
               "Rodriguez-Nikl et al. 2019; rounded"},
              {seaoc_in(1.566, SeismicDesignCategory::d), 81.6, 0.05, Metric::absolute}));
  cases.push_back(compare({"SEAOC PV1-2012, S_DS 1.566 g, SDC D", "displacement, m",
                           "Rodriguez-Nikl et al. 2019; rounded"},
                          {seaoc_pv1_2012_displacement(1.566, SeismicDesignCategory::d).value_m,
                           2.070, 0.005, Metric::absolute}));
  cases.push_back(compare({"ASCE 7-16 13.6.12, S_DS 1.050 g, I_e 1", "displacement, in",
                           "stamped permit calculation; rounded"},
                          {asce_in(1.050), 25.4, 0.051, Metric::absolute}));
  const auto separations =
      separations_of(Standard::asce7_16, asce7_16_displacement(1.050, 1.0).value_m);
  for (std::size_t i = 0; i < separations.size(); ++i)
    cases.push_back(compare({"ASCE 7-16 separation " + separations[i].what,
                             "share of the displacement", "stamped permit calculation"},
                            {separations[i].value_m / asce7_16_displacement(1.050, 1.0).value_m,
                             std::array{0.5, 1.0, 1.0, 2.0}[i], 1e-15}));
  cases.push_back(compare(
      {"ASCE 7-16, edge without a qualifying parapet, displacement 19.2 in", "separation, in",
       recalled},
      {separations_of(Standard::asce7_16, 19.2 * inch_m).back().value_m / inch_m, 48.0, 1e-15}));
  cases.push_back(
      compare({"SEAOC PV1-2012 below its floor, S_DS 0.7 g", "displacement, in", recalled},
              {seaoc_in(0.7, SeismicDesignCategory::d), 6.0, 1e-15}));
  cases.push_back(compare({"SEAOC PV1-2012, SDC C", "displacement, in", recalled},
                          {seaoc_in(1.5, SeismicDesignCategory::c), 6.0, 1e-15}));
  cases.push_back(compare({"ASCE 7-16 below its floor, S_DS 1.0 g", "displacement, in", recalled},
                          {asce_in(1.0), 24.0, 1e-15}));
}

void add_spectrum(std::vector<Case>& cases) {
  const TargetSpectrum spectrum(
      {.edition = asce7_16, .ss_g = 1.0, .s1_g = 0.4, .site_classes = {c}, .tl_s = 8.0});
  for (const auto& [period_s, sa_g] :
       {std::pair{0.0, 0.32}, {0.05, 0.56}, {0.3, 0.8}, {1.0, 0.4}, {16.0, 0.0125}})
    cases.push_back(
        compare({fmt::format("ASCE 7-16 design spectrum, S_s 1, S_1 0.4, class C, T_L 8 s, at {} s",
                             period_s),
                 "Sa, g", "worked by hand"},
                {spectrum.design_sa_g(period_s), sa_g, 1e-14}));
  const TargetSpectrum sheet(
      {.edition = asce7_16, .ss_g = 1.313, .s1_g = 0.471, .site_classes = {c, d}, .tl_s = 8.0});
  const std::string site = "permit sheet, 7-16, default site, S_s 1.313, S_1 0.471",
                    rounded = "stamped permit calculation; rounded";
  cases.push_back(compare({site, "F_a", rounded},
                          {site_coefficient_fa(asce7_16, c, 1.313), 1.2, 5e-4, Metric::absolute}));
  cases.push_back(compare({site, "F_v", rounded}, {site_coefficient_fv(asce7_16, d, 0.471), 1.829,
                                                   5e-4, Metric::absolute}));
  cases.push_back(
      compare({site, "S_DS, g", rounded}, {sheet.sds_g(), 1.050, 5e-4, Metric::absolute}));
  cases.push_back(
      compare({site, "S_D1, g", rounded}, {sheet.sd1_g(), 0.574, 5e-4, Metric::absolute}));
}

struct Table {
  AsceEdition edition;
  double (*coefficient)(AsceEdition, SiteClass, double);
  std::string name;
  double first, step;  ///< the columns, S_s or S_1 in g
  std::vector<std::pair<SiteClass, std::vector<double>>> rows;
};

/// Tabulated columns, the middle between each two, and beyond both ends; class E of 7-16 as far as
/// it is tabulated.
Case site_coefficients(const Table& table) {
  double worst = 0.0;
  int values = 0;
  for (const auto& [site, row] : table.rows) {
    const auto check = [&](double column, double expected) {
      worst =
          worse(worst,
                std::abs(table.coefficient(table.edition, site, table.first + column * table.step) /
                             expected -
                         1.0));
      ++values;
    };
    check(-0.5, row.front());
    for (std::size_t i = 0; i < row.size(); ++i) {
      check(static_cast<double>(i), row[i]);
      if (i > 0) check(static_cast<double>(i) - 0.5, 0.5 * (row[i - 1] + row[i]));
    }
    if (site != e || table.edition == asce7_10) check(static_cast<double>(row.size()), row.back());
  }
  return limit({fmt::format("{}, {} values: columns, middles, beyond the ends", table.name, values),
                "site coefficient", "the table of the standard"},
               {"largest relative difference", worst, 1e-14});
}

void add_site_coefficients(std::vector<Case>& cases) {
  const auto constant = [](double value) { return std::vector<double>{value, value}; };
  cases.push_back(site_coefficients({asce7_10,
                                     site_coefficient_fa,
                                     "ASCE 7-10 F_a",
                                     0.25,
                                     0.25,
                                     {{a, constant(0.8)},
                                      {b, constant(1.0)},
                                      {c, {1.2, 1.2, 1.1, 1.0, 1.0}},
                                      {d, {1.6, 1.4, 1.2, 1.1, 1.0}},
                                      {e, {2.5, 1.7, 1.2, 0.9, 0.9}}}}));
  cases.push_back(site_coefficients({asce7_10,
                                     site_coefficient_fv,
                                     "ASCE 7-10 F_v",
                                     0.1,
                                     0.1,
                                     {{a, constant(0.8)},
                                      {b, constant(1.0)},
                                      {c, {1.7, 1.6, 1.5, 1.4, 1.3}},
                                      {d, {2.4, 2.0, 1.8, 1.6, 1.5}},
                                      {e, {3.5, 3.2, 2.8, 2.4, 2.4}}}}));
  cases.push_back(site_coefficients({asce7_16,
                                     site_coefficient_fa,
                                     "ASCE 7-16 F_a",
                                     0.25,
                                     0.25,
                                     {{a, constant(0.8)},
                                      {b, constant(0.9)},
                                      {c, {1.3, 1.3, 1.2, 1.2, 1.2, 1.2}},
                                      {d, {1.6, 1.4, 1.2, 1.1, 1.0, 1.0}},
                                      {e, {2.4, 1.7, 1.3}}}}));
  cases.push_back(site_coefficients({asce7_16,
                                     site_coefficient_fv,
                                     "ASCE 7-16 F_v",
                                     0.1,
                                     0.1,
                                     {{a, constant(0.8)},
                                      {b, constant(0.8)},
                                      {c, {1.5, 1.5, 1.5, 1.5, 1.5, 1.4}},
                                      {d, {2.4, 2.2, 2.0, 1.9, 1.8, 1.7}},
                                      {e, {4.2}}}}));
}

}  // namespace

Chapter standards() {
  Chapter chapter{
      "7. Standards",
      "ASCE 7, SEAOC PV1, permit calculations",
      R"(Prescriptive displacements, separations, design spectra and site coefficients against published
calculations. *Recalled* values are from memory of the standard: such a case shows that they are applied, not
that they are correct.)",
      {}};
  add_displacements(chapter.cases);
  add_spectrum(chapter.cases);
  add_site_coefficients(chapter.cases);
  return chapter;
}

}  // namespace glissade::verification
