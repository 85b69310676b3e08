// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

namespace glissade {

/// Of ASCE 7-22, which has no site coefficients, a target is a spectrum by points or S_DS and S_D1.
enum class AsceEdition { asce7_10, asce7_16, asce7_22 };
/// `unknown`: the default class, D with F_a of at least 1.2 (ASCE 7-16, 11.4.3 and 11.4.4,
/// recalled; F_a and F_v of a published calculation); D in ASCE 7-10.
enum class SiteClass { a, b, c, d, e, unknown };

/// ASCE 7-10 / 7-16 site coefficients F_a (short period) and F_v (1 s), tables 11.4-1 and 11.4-2:
/// linear between the tabulated ss_g or s1_g, clamped at the ends. ASCE 7-16 class E beyond its
/// tabulated range is "site-specific" in the standard: InputError.
double site_coefficient_fa(AsceEdition edition, SiteClass site, double ss_g);
double site_coefficient_fv(AsceEdition edition, SiteClass site, double s1_g);

/// A design response spectrum, 5 % damped (ASCE 7-10 and 7-16, section 11.4.5 / 11.4.6).
struct DesignSpectrum {
  double sds_g = 0.0;  ///< > 0
  double sd1_g = 0.0;  ///< > 0
  double tl_s = 8.0;   ///< long-period transition

  double t0_s() const { return 0.2 * ts_s(); }
  double ts_s() const { return sd1_g / sds_g; }
  /// Spectral acceleration in g at a period >= 0.
  double sa_g(double period_s) const;
};

/// Target spectrum of a suite: edition, mapped values and the site classes whose spectra are
/// enveloped (A-D in Walters et al. 2012); or, of a site, the design values S_DS and S_D1; or the
/// design spectrum point by point.
struct DesignTarget {
  AsceEdition edition = AsceEdition::asce7_10;
  double ss_g = 0.0;  ///< > 0
  double s1_g = 0.0;  ///< > 0
  std::vector<SiteClass> site_classes = {SiteClass::d};
  double tl_s = 8.0;
  double sds_g = 0.0, sd1_g = 0.0;  ///< above 0: these count in place of mapped values
  /// Not empty: these points count, linear in between; from 0.01 s or less to 5 s or more. The
  /// first holds below it; beyond the last the acceleration falls as 1/T.
  std::vector<double> period_s, design_sa_g;
  std::vector<int> exceptions;  ///< of ASCE 7-16, 11.4.8, that are taken: 1, 2, 3

  bool is_mapped() const { return sds_g == 0.0 && period_s.empty(); }
};
/// MCE_R over the design earthquake (ASCE 7-16, 11.4.5).
inline constexpr double mce_over_dbe = 1.5;
/// "DBE", "MCE", or empty: another level, or that of the DBE is not known (0).
std::string earthquake_name(double level, double dbe_level);

/// The envelope over the site classes of the target.
class TargetSpectrum {
 public:
  explicit TargetSpectrum(const DesignTarget& target);
  double design_sa_g(double period_s) const;  ///< DBE: 2/3 of MCE_R
  double mce_sa_g(double period_s) const { return mce_over_dbe * design_sa_g(period_s); }
  /// Largest S_DS of the classes; of points 90 % of the largest acceleration from 0.2 to 5 s (ASCE
  /// 7-16, 21.4, recalled: verify against the standard).
  double sds_g() const;
  /// Largest S_D1 of the classes; of points the largest of their S_a T from 1 to 2 s, where V_s30
  /// is above 366 m/s, and to 5 s else: taken to 5 s, which is never less (21.4, recalled).
  double sd1_g() const;

 private:
  std::vector<DesignSpectrum> spectra_;
  std::vector<double> period_s_, design_sa_g_;
};

/// What is said of site class F, which the enumeration has not.
inline constexpr const char* site_class_f_refusal =
    "site class F has no site coefficients: ASCE 7-16, 11.4.7 and 20.3.1 (recalled) require a site "
    "response analysis";
/// "A" ... "E", "default"; InputError otherwise.
SiteClass parse_site_class(const std::string& text);
std::string to_string(SiteClass site);
AsceEdition parse_asce_edition(const std::string& text);  ///< "asce7_10" ...
std::string to_string(AsceEdition edition);
std::string edition_name(AsceEdition edition);  ///< "ASCE 7-10"
/// "ASCE 7-16, S_S 1.5 g, S_1 0.6 g, site classes C, D", "ASCE 7-16, S_DS 1 g, S_D1 0.6 g", "ASCE
/// 7-16, spectrum of 22 points".
std::string to_string(const DesignTarget& target);

}  // namespace glissade
