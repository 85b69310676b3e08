// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <span>

#include "block_cases.hpp"
#include "glissade/block/slide.hpp"

namespace glissade::verification {
namespace {

bool same(const SlipResult& a, const SlipResult& b) {
  return a.peak_displacement_m == b.peak_displacement_m &&
         a.residual.along_m == b.residual.along_m && a.peak_downslope_m == b.peak_downslope_m &&
         a.peak_upslope_m == b.peak_upslope_m && a.peak_velocity_mps == b.peak_velocity_mps &&
         a.slip_duration_s == b.slip_duration_s && a.slip_phases == b.slip_phases;
}

/// `b` with lengths scaled by one factor and times by another, both powers of two.
SlipResult scaled(SlipResult b, double length, double time) {
  for (double* x :
       {&b.peak_displacement_m, &b.residual.along_m, &b.peak_downslope_m, &b.peak_upslope_m})
    *x *= length;
  b.peak_velocity_mps *= length / time;
  b.slip_duration_s *= time;
  return b;
}

std::vector<double> with_midpoints(std::span<const double> x) {
  std::vector<double> y;
  for (std::size_t i = 0; i < x.size(); ++i) {
    y.push_back(x[i]);
    y.push_back(0.5 * (x[i] + (i + 1 < x.size() ? x[i + 1] : 0.0)));
  }
  return y;
}

}  // namespace

std::vector<Case> invariants(const Suite& suite) {
  int mirror = 0, field = 0, padding = 0, clock = 0, histories = 0;
  double midpoints = 0.0;
  for (const Motion& m : suite.motions)
    for (const double mu : {0.1, 0.3, 0.5})
      for (const double slope_deg : {0.0, 1.19, 4.0}) {
        ++histories;
        const auto &a = m.horizontal_mps2[0], &w = m.vertical_mps2;
        const double f = m.scale;
        const Block block{mu, slope_deg * rad_per_deg}, mirrored{mu, -slope_deg * rad_per_deg};
        Block twice_as_heavy = block;
        twice_as_heavy.gravity_mps2 *= 2.0;
        const SlipResult plain = slide({m.dt_s, a, w, f, f}, block);

        SlipResult reflected = slide({m.dt_s, a, w, -f, f}, mirrored);
        if (slope_deg == 0.0) {  // up and down change places
          std::swap(reflected.peak_downslope_m, reflected.peak_upslope_m);
          reflected.residual.along_m *= -1.0;
        }
        mirror += same(reflected, plain) ? 0 : 1;
        field += same(slide({m.dt_s, a, w, 2 * f, 2 * f}, twice_as_heavy), scaled(plain, 2.0, 1.0))
                     ? 0
                     : 1;
        clock += same(slide({4 * m.dt_s, a, w, f, f}, block), scaled(plain, 16.0, 4.0)) ? 0 : 1;
        std::vector<double> long_a = a.copy(), long_w = w.copy();
        long_a.resize(2 * a.size(), 0.0);
        long_w.resize(2 * w.size(), 0.0);
        padding += same(slide({m.dt_s, long_a, long_w, f, f}, block), plain) ? 0 : 1;
        const auto fine_a = with_midpoints(a), fine_w = with_midpoints(w);
        const SlipResult fine = slide({0.5 * m.dt_s, fine_a, fine_w, f, f}, block);
        if (plain.peak_displacement_m == 0.0) continue;
        midpoints =
            worse(midpoints, std::abs(fine.peak_displacement_m / plain.peak_displacement_m - 1.0));
        midpoints = worse(midpoints, std::abs(fine.residual.along_m - plain.residual.along_m) /
                                         plain.peak_displacement_m);
      }
  const std::string law = "similitude of the equation of motion";
  return {
      all_equal({"mirrored motion and slope", "all results, mirrored",
                 "symmetry of the equation of motion"},
                {mirror, histories}),
      all_equal({"motion and gravity doubled", "all results, doubled", law}, {field, histories}),
      all_equal({"step four times as long", "slips x 16, times x 4", law}, {clock, histories}),
      all_equal({"as many zeros appended as there are samples", "all results", "unchanged"},
                {padding, histories}),
      limit({"interpolated samples inserted", "peak and residual slip",
             "unchanged: the motion is piecewise linear"},
            {"largest relative difference of " + std::to_string(histories), midpoints, 1e-11})};
}

}  // namespace glissade::verification
