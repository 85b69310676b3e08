// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "glissade/study/plan/skip.hpp"
#include "glissade/study/results.hpp"

namespace glissade {

/// Writes out_dir/report.html, out_dir/tables/*.csv and out_dir/figures/*.{svg,pdf,gp,dat} in the
/// place of an earlier report (results_folder.hpp). Tables are written first: they are there even
/// where gnuplot is not. Throws InputError where a file cannot be written or gnuplot does not
/// manage.
void write_report(const Results& results, const std::filesystem::path& out_dir,
                  const std::vector<Skip>& skips = {});

}  // namespace glissade
