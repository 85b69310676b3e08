// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "glissade/motion/motion.hpp"

// The convergence of the published scheme (Rodriguez-Nikl et al. 2019, section "Convergence"): its
// residual displacement at P substeps of a sample interval, with the exact solution beside it. The
// roof is rigid and moves horizontally only.
namespace glissade::convergence {

/// P, as in the paper; it takes the last for the truth.
inline constexpr std::array paper_substeps{1, 2, 4, 8, 16, 32, 64, 128, 256};
inline constexpr std::size_t chosen_step = 6, finest_step = 8;  ///< P = 64 and 256
/// What the paper states of P = 64 on its one record.
inline constexpr double paper_largest_error = 0.0048, paper_longest_s = 0.09;
/// A residual is clear if it is at least this share of the exact peak displacement.
inline constexpr double clear_share = 0.1;

struct Scene {
  double slope_deg = 0.0, mu = 0.0, ppa_g = 0.0;
};
/// The paper's 60 scenes, by slope, then friction, then peak acceleration of the roof.
std::vector<Scene> paper_scenes();

/// One scene on one record. Displacements are in plan.
struct Case {
  std::string record;
  Scene scene;
  std::vector<double> residual_m;  ///< of the published scheme, signed, by substeps
  double exact_residual_m = 0.0, exact_peak_m = 0.0;
  std::vector<double> scheme_s;  ///< processor time of each history of the scheme
  double exact_s = 0.0;          ///< of slide()
};

/// The paper's scenes under the first component of `motion`, scaled to each scene's peak; zeros
/// that pad the record at its end are left out. Expects a motion that is not zero throughout.
std::vector<Case> run_cases(const Motion& motion, std::span<const int> substeps);

/// What an error of the residual at P substeps is relative to.
enum class Measure {
  finest,          ///< the residual at the finest P: the paper's measure
  exact_residual,  ///< the exact residual
  exact_peak,      ///< the exact peak displacement; the difference is from the exact residual
};
/// NaN where the reference is zero: the array does not slide, or comes back exactly.
double error_of(const Case& c, std::size_t step, Measure measure);

/// The residual by which a case is chosen as one with a clear residual.
enum class ClearBy { any, exact, finest };

struct ErrorSummary {
  double largest = std::numeric_limits<double>::quiet_NaN();
  double median = std::numeric_limits<double>::quiet_NaN();
  const Case* worst = nullptr;  ///< of `largest`
  std::size_t counted = 0;      ///< cases with a reference, of those chosen
};
ErrorSummary error_summary(std::span<const Case> cases, std::size_t step, Measure measure,
                           ClearBy clear = ClearBy::any);

/// Mean of the two in the middle where the count is even; NaN of nothing.
double median(std::vector<double> values);

}  // namespace glissade::convergence
