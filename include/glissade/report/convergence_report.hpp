// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "glissade/report/figures.hpp"
#include "glissade/report/table.hpp"
#include "glissade/study/convergence_error.hpp"

namespace glissade {

/// How long the histories took, where it is known: a run knows, a results file does not.
using MaybeTimes = std::optional<ConvergenceTimes>;

/// By P: largest and median error by each measure, the worst scene, longest and median time.
Table convergence_table(const ConvergenceResults& results, const MaybeTimes& times);
/// By record: the largest errors at the P the paper chose.
Table convergence_records_table(const ConvergenceResults& results);
/// Every scene of every record: what the exact solution and the scheme at each P give.
Table convergence_scenes_table(const ConvergenceResults& results);

/// Largest error and longest time over P, as Rodriguez-Nikl et al. (2019), Fig. 5.
Figure convergence_figure(const ConvergenceResults& results, const MaybeTimes& times);

/// What the paper states beside what came out.
std::vector<std::string> convergence_sentences(const ConvergenceResults& results,
                                               const MaybeTimes& times);
/// For the terminal, in plain ASCII.
std::string convergence_summary(const ConvergenceResults& results, const MaybeTimes& times);

/// Writes out_dir/report.html, out_dir/tables/*.csv and
/// out_dir/figures/convergence.{svg,pdf,gp,dat}, as write_report() does.
void write_convergence_report(const ConvergenceResults& results, const MaybeTimes& times,
                              const std::filesystem::path& out_dir);

}  // namespace glissade
