// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace glissade {

// Distributions of test statistics by Boost.Math, whose templates are slow to compile: they are
// instantiated here only.

double student_quantile(double freedom, double probability);
/// P(T > t).
double student_upper_tail(double freedom, double t);
double chi_squared_quantile(double freedom, double probability);
/// The ends of Clopper and Pearson's interval of a share, each with `tail` beyond; the numbers need
/// not be whole.
double binomial_lower_end(double trials, double successes, double tail);
double binomial_upper_end(double trials, double successes, double tail);

/// ln |gamma(x)|, for threads too: std::lgamma writes the sign to a global variable.
double log_gamma(double x);

}  // namespace glissade
