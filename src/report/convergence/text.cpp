// SPDX-License-Identifier: GPL-3.0-or-later
#include "convergence/text.hpp"

#include <fmt/format.h>

#include <cmath>

#include "glissade/report/format.hpp"

namespace glissade {

std::string percent(double share) {
  return std::isfinite(share) ? format_number(100.0 * share) + " %" : "-";
}

std::string stated_percent(double share) { return fmt::format("{:g} %", 100.0 * share); }

ErrorSummary clear_error(const ConvergenceResults& results, std::size_t step) {
  return error_summary(results, step, ErrorMeasure::finest,
                       {.least_residual_of_peak = clear_residual});
}

std::string duration(double seconds) {
  if (seconds < 1e-3) return format_number(1e6 * seconds) + " us";
  if (seconds < 1.0) return format_number(1e3 * seconds) + " ms";
  return format_number(seconds) + " s";
}

std::string scene_text(const ConvergenceResults& results, const HistoryIndex& history) {
  const ConvergenceScene& scene = results.scenes[history.scene];
  return fmt::format("{}, slope {:g} deg, mu {:g}, {:g} g", results.records[history.record].id,
                     scene.slope_deg, scene.mu, scene.ppa_g);
}

}  // namespace glissade
