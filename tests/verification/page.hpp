// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "case.hpp"

namespace glissade::verification {

/// Takes the cases whose reference is another part of this code out of their chapters, into one of
/// their own.
Chapter consistency(std::vector<Chapter>& chapters);

/// Kills, full disks, damaged files: figures of commands that are too long for this program.
Chapter reliability();

/// The manual in Markdown.
std::string page(const std::vector<Chapter>& chapters);

/// A page without what another machine may measure otherwise: the result columns and the measured
/// tables. Two pages with the same cases, references, tolerances, verdicts and text are equal in
/// this form.
std::string comparable(const std::string& page);

/// The first line in which two comparable pages differ, both versions; empty when equal.
std::string first_difference(const std::string& committed, const std::string& made);

}  // namespace glissade::verification
