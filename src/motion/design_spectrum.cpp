// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/motion/design_spectrum.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "glissade/core/contract.hpp"
#include "glissade/core/error.hpp"

namespace glissade {
namespace {

/// One row of a site-coefficient table.
using Row = std::vector<double>;
using Table = std::array<Row, 5>;  // by site class, A to E

struct SiteTable {
  const char* parameter;  // what the columns are of
  Row columns;
  Table rows;  // a row shorter than the columns is "site-specific" beyond
};

// ASCE 7-10 and 7-16, tables 11.4-1 (F_a) and 11.4-2 (F_v).
const SiteTable& fa_table(AsceEdition edition) {
  static const SiteTable asce7_10{"ss_g",
                                  {0.25, 0.5, 0.75, 1.0, 1.25},
                                  {Row{0.8, 0.8, 0.8, 0.8, 0.8},    // A
                                   Row{1.0, 1.0, 1.0, 1.0, 1.0},    // B
                                   Row{1.2, 1.2, 1.1, 1.0, 1.0},    // C
                                   Row{1.6, 1.4, 1.2, 1.1, 1.0},    // D
                                   Row{2.5, 1.7, 1.2, 0.9, 0.9}}};  // E
  static const SiteTable asce7_16{"ss_g",
                                  {0.25, 0.5, 0.75, 1.0, 1.25, 1.5},
                                  {Row{0.8, 0.8, 0.8, 0.8, 0.8, 0.8},  // A
                                   Row{0.9, 0.9, 0.9, 0.9, 0.9, 0.9},  // B
                                   Row{1.3, 1.3, 1.2, 1.2, 1.2, 1.2},  // C
                                   Row{1.6, 1.4, 1.2, 1.1, 1.0, 1.0},  // D
                                   Row{2.4, 1.7, 1.3}}};               // E
  return edition == AsceEdition::asce7_10 ? asce7_10 : asce7_16;
}

const SiteTable& fv_table(AsceEdition edition) {
  static const SiteTable asce7_10{"s1_g",
                                  {0.1, 0.2, 0.3, 0.4, 0.5},
                                  {Row{0.8, 0.8, 0.8, 0.8, 0.8},    // A
                                   Row{1.0, 1.0, 1.0, 1.0, 1.0},    // B
                                   Row{1.7, 1.6, 1.5, 1.4, 1.3},    // C
                                   Row{2.4, 2.0, 1.8, 1.6, 1.5},    // D
                                   Row{3.5, 3.2, 2.8, 2.4, 2.4}}};  // E
  static const SiteTable asce7_16{"s1_g",
                                  {0.1, 0.2, 0.3, 0.4, 0.5, 0.6},
                                  {Row{0.8, 0.8, 0.8, 0.8, 0.8, 0.8},  // A
                                   Row{0.8, 0.8, 0.8, 0.8, 0.8, 0.8},  // B
                                   Row{1.5, 1.5, 1.5, 1.5, 1.5, 1.4},  // C
                                   Row{2.4, 2.2, 2.0, 1.9, 1.8, 1.7},  // D
                                   Row{4.2}}};                         // E
  return edition == AsceEdition::asce7_10 ? asce7_10 : asce7_16;
}

bool is_positive(double value) { return std::isfinite(value) && value > 0.0; }

double site_coefficient(const SiteTable& table, SiteClass site, double value_g) {
  if (!is_positive(value_g)) {
    throw InputError({"", fmt::format("{} = {} is not a positive number", table.parameter, value_g),
                      "give the mapped acceleration in g", ""});
  }
  const SiteClass row_class = site == SiteClass::unknown ? SiteClass::d : site;
  const Row& row = table.rows[static_cast<std::size_t>(row_class)];
  const Row& columns = table.columns;
  const std::size_t last = row.size() - 1;
  if (row.size() < columns.size() && value_g > columns[last]) {
    throw InputError(
        {"",
         fmt::format("{} = {} is above {}, up to which ASCE 7-16 has a coefficient for site class "
                     "{}; 11.4.8 requires a ground motion hazard analysis of "
                     "the site from S_S = 1 g or S_1 = 0.2 g on",
                     table.parameter, value_g, columns[last], to_string(site)),
         "give the spectrum of such an analysis (spectrum = \"FILE.csv\"), or sds_g and sd1_g",
         ""});
  }
  if (value_g <= columns.front()) return row.front();
  if (value_g >= columns[last]) return row[last];
  const auto right =
      static_cast<std::size_t>(std::ranges::upper_bound(columns, value_g) - columns.begin());
  const double fraction = (value_g - columns[right - 1]) / (columns[right] - columns[right - 1]);
  return std::lerp(row[right - 1], row[right], fraction);
}

template <typename Enum, std::size_t n>
Enum parse(const std::string& text, const std::array<const char*, n>& names, const char* what) {
  const auto found = std::ranges::find(names, text);
  if (found != names.end()) return static_cast<Enum>(found - names.begin());
  std::string choices;
  for (const char* name : names)
    choices += fmt::format("{}\"{}\"", choices.empty() ? "" : ", ", name);
  throw InputError({"", fmt::format("\"{}\" is not {}", text, what), "give one of " + choices, ""});
}

constexpr std::array<const char*, 6> site_class_names = {"A", "B", "C", "D", "E", "default"};
constexpr std::array<const char*, 3> edition_names = {"asce7_10", "asce7_16", "asce7_22"};

}  // namespace

double site_coefficient_fa(AsceEdition edition, SiteClass site, double ss_g) {
  const double fa = site_coefficient(fa_table(edition), site, ss_g);
  constexpr double least_unknown = 1.2;
  return site == SiteClass::unknown && edition == AsceEdition::asce7_16
             ? std::max(fa, least_unknown)
             : fa;
}

double site_coefficient_fv(AsceEdition edition, SiteClass site, double s1_g) {
  return site_coefficient(fv_table(edition), site, s1_g);
}

double DesignSpectrum::sa_g(double period_s) const {
  GLISSADE_EXPECTS(period_s >= 0.0);
  if (period_s < t0_s()) return sds_g * (0.4 + 0.6 * period_s / t0_s());
  if (period_s <= ts_s()) return sds_g;
  if (period_s <= tl_s) return sd1_g / period_s;
  return sd1_g * tl_s / (period_s * period_s);
}

TargetSpectrum::TargetSpectrum(const DesignTarget& target)
    : period_s_(target.period_s), design_sa_g_(target.design_sa_g) {
  if (!period_s_.empty()) return;
  ProblemList problems;
  if (!is_positive(target.tl_s)) {
    problems.add({"", fmt::format("tl_s = {} is not a positive number", target.tl_s),
                  "give the mapped long-period transition in seconds", ""});
  }
  const auto add = [&](const DesignSpectrum& spectrum, const std::string& whose) {
    spectra_.push_back(spectrum);
    if (target.tl_s >= spectrum.ts_s()) return;
    problems.add(
        {"",
         fmt::format("tl_s = {} is below T_S = {:.4g} s{}", target.tl_s, spectrum.ts_s(), whose),
         "check the spectral accelerations and tl_s: mapped values of T_L are 4 to 16 s", ""});
  };
  if (target.sds_g > 0.0) {
    add({target.sds_g, target.sd1_g, target.tl_s}, "");
    problems.throw_if_any();
    return;
  }
  if (target.site_classes.empty()) {
    problems.add({"", "the design target has no site class", "give one or more of A to E", ""});
  }
  if (target.edition == AsceEdition::asce7_22) {
    problems.add({"", "ASCE 7-22 has no site coefficients for S_S and S_1",
                  "give the multi-period spectrum (spectrum = \"FILE.csv\"), or sds_g and sd1_g",
                  ""});
    problems.throw_if_any();
  }
  for (const SiteClass site : target.site_classes) {
    try {
      const double fa = site_coefficient_fa(target.edition, site, target.ss_g);
      const double fv = site_coefficient_fv(target.edition, site, target.s1_g);
      add({2.0 / 3.0 * fa * target.ss_g, 2.0 / 3.0 * fv * target.s1_g, target.tl_s},
          " of site class " + to_string(site));
    } catch (const InputError& error) {
      problems.add(error);
    }
  }
  problems.throw_if_any();
}

double TargetSpectrum::design_sa_g(double period_s) const {
  if (!period_s_.empty()) {
    const auto right =
        static_cast<std::size_t>(std::ranges::upper_bound(period_s_, period_s) - period_s_.begin());
    if (right == 0) return design_sa_g_.front();
    if (right == period_s_.size()) return design_sa_g_.back() * period_s_.back() / period_s;
    const double fraction =
        (period_s - period_s_[right - 1]) / (period_s_[right] - period_s_[right - 1]);
    return std::lerp(design_sa_g_[right - 1], design_sa_g_[right], fraction);
  }
  double envelope = 0.0;
  for (const DesignSpectrum& spectrum : spectra_)
    envelope = std::max(envelope, spectrum.sa_g(period_s));
  return envelope;
}

double TargetSpectrum::sds_g() const {
  if (!period_s_.empty()) {
    double largest = std::max(design_sa_g(0.2), design_sa_g(5.0));
    for (std::size_t i = 0; i < period_s_.size(); ++i) {
      if (period_s_[i] > 0.2 && period_s_[i] < 5.0) largest = std::max(largest, design_sa_g_[i]);
    }
    return 0.9 * largest;
  }
  return std::ranges::max(spectra_, {}, &DesignSpectrum::sds_g).sds_g;
}

double TargetSpectrum::sd1_g() const {
  if (!period_s_.empty()) {
    double largest = std::max(design_sa_g(1.0), 5.0 * design_sa_g(5.0));
    for (std::size_t i = 0; i < period_s_.size(); ++i) {
      if (period_s_[i] > 1.0 && period_s_[i] < 5.0)
        largest = std::max(largest, period_s_[i] * design_sa_g_[i]);
    }
    return largest;
  }
  return std::ranges::max(spectra_, {}, &DesignSpectrum::sd1_g).sd1_g;
}

SiteClass parse_site_class(const std::string& text) {
  if (text == "F")
    throw InputError({"", site_class_f_refusal, "use the spectrum of that analysis", ""});
  return parse<SiteClass>(text, site_class_names, "a site class");
}

std::string to_string(SiteClass site) { return site_class_names[static_cast<std::size_t>(site)]; }

AsceEdition parse_asce_edition(const std::string& text) {
  return parse<AsceEdition>(text, edition_names, "an edition of ASCE 7");
}

std::string to_string(AsceEdition edition) {
  return edition_names[static_cast<std::size_t>(edition)];
}

std::string earthquake_name(double level, double dbe_level) {
  constexpr double same = 1e-3;
  if (!(dbe_level > 0.0)) return "";
  if (std::abs(level / dbe_level - 1.0) < same) return "DBE";
  return std::abs(level / dbe_level - mce_over_dbe) < same ? "MCE" : "";
}

std::string edition_name(AsceEdition edition) {
  return "ASCE 7-" + to_string(edition).substr(std::string_view("asce7_").size());
}

std::string to_string(const DesignTarget& target) {
  const std::string edition = edition_name(target.edition);
  if (!target.period_s.empty())
    return fmt::format("{}, spectrum of {} points", edition, target.period_s.size());
  if (target.sds_g > 0.0)
    return fmt::format("{}, S_DS {:g} g, S_D1 {:g} g", edition, target.sds_g, target.sd1_g);
  std::vector<std::string> classes;
  for (const SiteClass site : target.site_classes) classes.push_back(to_string(site));
  return fmt::format("{}, S_S {:g} g, S_1 {:g} g, site class{} {}", edition, target.ss_g,
                     target.s1_g, classes.size() > 1 ? "es" : "", fmt::join(classes, ", "));
}

}  // namespace glissade
