// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/report/html_text.hpp"
#include "glissade/report/table.hpp"
#include "glissade/study/results.hpp"

namespace glissade {

/// Prescribed displacements beside the results, with the provisions. Nothing without standards.
Html standards_html(const Results& results, const Table& standards);

}  // namespace glissade
