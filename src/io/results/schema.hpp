// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/study/results.hpp"
#include "results/hdf5_file.hpp"

namespace glissade {

// The layout of the results file, named once for both ways: every dataset, its unit and its
// description.

void exchange(const Hdf5Writer& archive, const Results& results);
void exchange(const Hdf5Reader& archive, Results& results);

}  // namespace glissade
