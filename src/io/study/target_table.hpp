// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/motion/design_spectrum.hpp"
#include "toml_table.hpp"

namespace glissade {

/// A design target: edition, ss_g, s1_g, site_classes = ["A", ...] or site_class
/// = "D" (the default), tl_s (default 8).
DesignTarget read_target(const TomlTable& table);

}  // namespace glissade
