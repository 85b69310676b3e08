// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "glissade/motion/motion.hpp"

namespace glissade {

/// Largest |acceleration|; 0 for an empty record.
double peak_ground_acceleration_mps2(std::span<const double> acceleration_mps2);
/// Largest |velocity|, integrated exactly for piecewise-linear acceleration from rest, extrema
/// inside intervals and the interval to zero after the last sample included. dt_s > 0.
double peak_ground_velocity_mps(double dt_s, std::span<const double> acceleration_mps2);

/// Largest |displacement| at the samples, integrated from rest as the velocity is. dt_s > 0.
double peak_ground_displacement_m(double dt_s, std::span<const double> acceleration_mps2);
/// When two shares (0 to 1, increasing) of the integral of the squared accelerations of up to two
/// components together are reached; {0, 0} for motions that are zero throughout.
std::array<double, 2> arias_times_s(double dt_s, std::span<const double> first_mps2,
                                    std::span<const double> second_mps2,
                                    const std::array<double, 2>& shares);
/// D5-95: the time between 5 and 95 % of the integral of the squared accelerations, of up to two
/// components together (Trifunac & Brady 1975; Husid 1969). 0 for motions that are zero throughout.
double significant_duration_s(double dt_s, std::span<const double> first_mps2,
                              std::span<const double> second_mps2 = {});

/// Combination of two horizontal components. With one component it counts as both.
enum class HorizontalCombination { geometric_mean, srss };
double combine(HorizontalCombination combination, double first, double second);

/// 5 % damped pseudo-acceleration of the motion's horizontals (scale not applied), m/s2, one per
/// period.
std::vector<double> horizontal_spectrum_mps2(const Motion& motion,
                                             std::span<const double> periods_s,
                                             HorizontalCombination combination,
                                             double damping_ratio = 0.05);
double horizontal_pga_mps2(const Motion& motion, HorizontalCombination combination);
double horizontal_pgv_mps(const Motion& motion, HorizontalCombination combination);
double horizontal_pgd_m(const Motion& motion, HorizontalCombination combination);

/// pi/(2 g) times the integral of a^2 (Arias 1970), exact for a piecewise-linear record with its
/// last interval to zero. Geometric mean of the horizontals, m/s.
double arias_intensity_mps(const Motion& motion);

/// Largest absolute velocity, at the samples, of a roof that is a linear oscillator on the ground,
/// one per period; 0: of the ground. Geometric mean of the horizontals (scale not applied).
std::vector<double> horizontal_roof_velocity_mps(const Motion& motion,
                                                 std::span<const double> periods_s,
                                                 double damping_ratio = 0.05);

/// Average spectral acceleration: the geometric mean over the periods and both components (Eads,
/// Miranda & Lignos 2015, EESD 44:2057-2073), m/s2.
double average_sa_mps2(const Motion& motion, std::span<const double> periods_s,
                       double damping_ratio = 0.05);

}  // namespace glissade
