// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glissade/core/data_table.hpp"
#include "glissade/study/results.hpp"
#include "results/hdf5_file.hpp"

namespace glissade {

// The layout of the results file: every dataset, its unit and its description. What is read back is
// named once for both ways.

void write_content(const Hdf5Writer& archive, const Results& results,
                   const std::vector<DataTable>& tables);
/// The study with its files, and what the run had to remark.
void read_run(const Hdf5Reader& archive, Results& results);
/// Cases, records, suites and histories. Precondition: the results have their study.
void read_histories(const Hdf5Reader& archive, Results& results);

}  // namespace glissade
