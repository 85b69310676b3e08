// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "glissade/study/convergence_error.hpp"

// What the tables, the figure and the page of a convergence study share.
namespace glissade {

/// What Rodriguez-Nikl et al. (2019), "Convergence", state of their record, Tokachi-Oki 2003.
namespace published {
inline constexpr int substeps = 64, finest = 256;  ///< P it chose, and took for the truth
inline constexpr double largest_error = 0.0048;
inline constexpr double longest_s = 0.09;  ///< "less than"
}  // namespace published

/// A residual that is a smaller share of the peak displacement makes an error relative to it say
/// little.
inline constexpr double clear_residual = 0.1;

/// "0.48 %", with three digits however small; "-" for NaN.
std::string percent(double share);
/// "0.48 %", "10 %": all digits given, for numbers stated rather than found.
std::string stated_percent(double share);
/// The errors by the paper's measure, of histories with a clear residual.
ErrorSummary clear_error(const ConvergenceResults& results, std::size_t step);
/// "12 ms", "3.4 us", "1.2 s".
std::string duration(double seconds);
/// "rsn953, slope 7 deg, mu 0.1, 1 g"
std::string scene_text(const ConvergenceResults& results, const HistoryIndex& history);

}  // namespace glissade
