// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "glissade/motion/design_spectrum.hpp"
#include "toml/toml_table.hpp"

namespace glissade {

/// A design target: edition, and one of
/// - ss_g, s1_g, site_class = "D" (the usual one) or "default", or site_classes = ["A", ...],
/// - sds_g and sd1_g,
/// - spectrum, a CSV file of two columns, period_s and design_sa_g or mce_sa_g, relative to
///   `folder`;
/// tl_s (8 where absent) goes with the first two, hazard_analysis with each.
/// `mapped` gets what ss_g, s1_g, site_class and tl_s state beside a spectrum. Where it is null
/// they have no effect there, which is reported.
DesignTarget read_target(const TomlTable& table, std::optional<DesignTarget>* mapped = nullptr);

}  // namespace glissade
