// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glissade/report/figure.hpp"
#include "glissade/study/plan/skip.hpp"
#include "glissade/study/results.hpp"

namespace glissade {

/// A figure with its drawing.
struct DrawnFigure {
  Figure figure;
  std::string svg;
};

/// The whole report in one page that needs nothing else: styles and drawings inline, no scripts, no
/// network. `skips` come from a run and are not in the results file: without it the page points
/// to run.json.
std::string html_report(const Results& results, const std::vector<DrawnFigure>& figures,
                        const std::vector<Skip>& skips = {});

}  // namespace glissade
