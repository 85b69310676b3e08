// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "glissade/motion/design_spectrum.hpp"

namespace glissade {

/// Walters et al. (2012) have two suites for each level: one for site classes A to D, whose spectra
/// are enveloped, and one for E.
enum class SiteGroup { a_to_d, e };

/// One of the five Seismic Intensity Levels of Walters et al. (2012): largest mapped values (Table
/// 1) and limits on the motions (Table 2).
struct WaltersLevel {
  double ss_g, s1_g;
  double min_magnitude, max_magnitude;
  double min_distance_km, max_distance_km;
  double min_vs30_mps, max_vs30_mps;
  double max_scale;
};

/// Level 0 to 4; InputError otherwise.
const WaltersLevel& walters_level(int level, SiteGroup sites = SiteGroup::a_to_d);

/// The largest mapped values of the level with the site classes of the group, ASCE 7-10. InputError
/// for a level outside 0-4.
DesignTarget walters_target(int level, SiteGroup sites = SiteGroup::a_to_d);

/// Mapped values of ASCE 7 for a site, in g.
struct MappedValues {
  double ss_g = 0.0, s1_g = 0.0;  ///< > 0
};

/// The Intensity Level of a site: the lowest whose largest S_s and S_1 (Table 1) are not exceeded
/// by those of the site. Empty above Level 4.
std::optional<int> intensity_level(const MappedValues& site);

}  // namespace glissade
