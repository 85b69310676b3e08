// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/two_axes/history/elliptic_stop.hpp"

#include <gtest/gtest.h>

#include "two_axis_truth/radau.hpp"

namespace glissade::block_detail::two_axes {
namespace elliptic_stop_test {

using test::Long;

/// v' = d - n M M v / |M v| in long double. With dt = |M v| dtau it is smooth to the end,
///   dv/dtau = |M v| d - n M M v,
/// and |v| falls exponentially: RK4 until it is 1e-17 of its first value.
struct Exact {
  Long time = 0, s = 0, y = 0, path = 0;

  Exact(Vector v0, Vector d, Long n, Long aspect) {
    using State = std::array<Long, 6>;  // v, displacement, time, path
    const auto rate = [&](const State& x) {
      const Long size = std::hypot(x[0], aspect * x[1]);
      return State{size * d.s - n * x[0],
                   size * d.y - n * aspect * aspect * x[1],
                   size * x[0],
                   size * x[1],
                   size,
                   size * std::hypot(x[0], x[1])};
    };
    const auto moved = [](const State& x, Long h, const State& k) {
      State to;
      for (std::size_t i = 0; i < 6; ++i) to[i] = x[i] + h * k[i];
      return to;
    };
    const Long h = 2e-4L / n, first = std::hypot(v0.s, v0.y);
    State x{v0.s, v0.y};
    while (std::hypot(x[0], x[1]) > 1e-17L * first) {
      const State a = rate(x), b = rate(moved(x, 0.5L * h, a)), c = rate(moved(x, 0.5L * h, b)),
                  e = rate(moved(x, h, c));
      for (std::size_t i = 0; i < 6; ++i) x[i] += h / 6.0L * (a[i] + 2.0L * (b[i] + c[i]) + e[i]);
    }
    s = x[2], y = x[3], time = x[4], path = x[5];
  }
};

TEST(elliptic_stop, is_where_the_block_comes_to_rest) {
  for (const double aspect : {0.5, 0.8, 1.25, 2.0})
    for (const double load : {0.0, 0.3, 0.6})
      for (const double angle : {0.3, 1.2, 2.0, 2.9}) {
        const Vector v{0.01 * std::cos(angle), 0.01 * std::sin(angle)},
            d{2.0 * load, 0.5 * aspect * load};
        const double n = 2.5;
        const Exact exact(v, d, n, aspect);
        for (const double enough_m : {1e-7, 1e-9, 1e-11}) {
          SCOPED_TRACE(testing::Message()
                       << aspect << ' ' << load << ' ' << angle << ' ' << enough_m);
          const Stop stop = stop_on_an_ellipse(v, d, n, aspect, enough_m).stop;
          EXPECT_NEAR(stop.displacement.s, static_cast<double>(exact.s), enough_m);
          EXPECT_NEAR(stop.displacement.y, static_cast<double>(exact.y), enough_m);
          EXPECT_NEAR(stop.path / static_cast<double>(exact.path), 1.0, 5e-3);
          EXPECT_NEAR(stop.time_s, static_cast<double>(exact.time), std::sqrt(enough_m));
        }
      }
}

TEST(elliptic_stop, does_not_come_where_the_load_exceeds_friction) {
  EXPECT_EQ(stop_on_an_ellipse({0.1, 0.1}, {2.6, 0.0}, 2.5, 0.8, 1e-9).stop.time_s, never);
  EXPECT_EQ(stop_on_an_ellipse({0.1, 0.1}, {0.0, 2.1}, 2.5, 0.8, 1e-9).stop.time_s, never);
  EXPECT_NE(stop_on_an_ellipse({0.1, 0.1}, {0.0, 1.9}, 2.5, 0.8, 1e-9).stop.time_s, never);
}

}  // namespace elliptic_stop_test
}  // namespace glissade::block_detail::two_axes
