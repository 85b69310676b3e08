// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glissade/study/config.hpp"
#include "keys/key.hpp"

namespace glissade {

/// The keys of [[published]]: a value of a publication, drawn in a figure of [clearance] or
/// [chart].
const KeyTable<PublishedPoint>& published_table();

/// Reports a figure of an analysis that the file does not have.
std::vector<PublishedPoint> read_published(const TomlTable& root);

}  // namespace glissade
