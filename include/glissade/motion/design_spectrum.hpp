// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

namespace glissade {

enum class AsceEdition { asce7_10, asce7_16 };
enum class SiteClass { a, b, c, d, e };

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

/// Target spectrum of a suite: mapped values, edition and the site classes whose spectra are
/// enveloped (A-D in Walters et al. 2012).
struct DesignTarget {
  AsceEdition edition = AsceEdition::asce7_10;
  double ss_g = 0.0;  ///< > 0
  double s1_g = 0.0;  ///< > 0
  std::vector<SiteClass> site_classes = {SiteClass::d};
  double tl_s = 8.0;
};

/// The envelope over the site classes of the target. Multiply by 1.5 for MCE_R.
class TargetSpectrum {
 public:
  explicit TargetSpectrum(const DesignTarget& target);
  double design_sa_g(double period_s) const;  ///< DBE: 2/3 of MCE_R
  double mce_sa_g(double period_s) const { return 1.5 * design_sa_g(period_s); }
  double sds_g() const;  ///< largest S_DS of the classes
  double sd1_g() const;  ///< largest S_D1 of the classes

 private:
  std::vector<DesignSpectrum> spectra_;
};

SiteClass parse_site_class(const std::string& text);  ///< "A" ... "E"; InputError otherwise
std::string to_string(SiteClass site);
AsceEdition parse_asce_edition(const std::string& text);  ///< "asce7_10", "asce7_16"
std::string to_string(AsceEdition edition);

}  // namespace glissade
