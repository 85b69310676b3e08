// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "glissade/core/data_table.hpp"
#include "glissade/study/results.hpp"

namespace glissade {

/// The version of the results file's layout; a reader refuses others.
inline constexpr int results_format_version = 20;

/// Writes an HDF5 file that holds the study, the motions, the histories and `tables`, and nothing
/// else: the same results give the same bytes. Written to a temporary name beside `file`, read back
/// and compared, then renamed. Throws InputError, saying why and what to do, where it cannot be
/// written or reads back otherwise; nothing is left then, and an older file stays as it was.
/// Precondition: the results are those of their study_text.
/// @param tables what the analyses found, for users of the file: group `tables`; not read back
void write_results(const std::filesystem::path& file, const Results& results,
                   const std::vector<DataTable>& tables = {});

/// Reads what write_results wrote, to the last bit, and analyses it as its study asks. Throws
/// InputError for files that are no glissade results, of another format version, cut short or
/// damaged, and where the parts are not those of the study.
Results read_results(const std::filesystem::path& file);
/// The same without analyses.
Results read_histories(const std::filesystem::path& file);

/// Of what a results file is.
struct ResultsOrigin {
  std::string study_text, plan_hash;
};
/// Throws as read_results, where the file is not whole.
ResultsOrigin read_origin(const std::filesystem::path& file);

}  // namespace glissade
