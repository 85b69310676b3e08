// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "glissade/report/figure.hpp"
#include "glissade/report/table.hpp"
#include "glissade/sampling/friction_statistics.hpp"

namespace glissade {

/// A row for each test: breakaway and sliding friction.
Table pull_tests_table(const PullTestSummary& summary);
/// A row for each direction and for sliding and breakaway: the friction over tests.
Table friction_table(const PullTestSummary& summary);
/// Pull over normal force over displacement, a line for each test (as Fig. 9 of Walters et al.
/// 2012), with the mean of sliding friction and mean - 2 std by direction.
Figure friction_figure(const std::vector<PullTest>& tests, const PullTestSummary& summary);

/// Writes out_dir/tables/{friction,pull_tests}.csv and out_dir/figures/friction.{svg,pdf,gp,dat},
/// in the place of an earlier report (results_folder.hpp).
void write_friction_report(const std::vector<PullTest>& tests, const PullTestSummary& summary,
                           const std::filesystem::path& out_dir);

}  // namespace glissade
