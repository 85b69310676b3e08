// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace glissade::block_detail {

/// Tableau of SDIRK4, five stages, L-stable, with an embedded error estimate (Hairer & Wanner 1996,
/// IV.6; the last row holds the weights).
struct Sdirk4 {
  static constexpr int stages = 5;
  static constexpr double gamma = 0.25;
  static constexpr double at[stages] = {1.0 / 4, 3.0 / 4, 11.0 / 20, 1.0 / 2, 1.0};
  static constexpr double a[stages][stages - 1] = {{},
                                                   {1.0 / 2},
                                                   {17.0 / 50, -1.0 / 25},
                                                   {371.0 / 1360, -137.0 / 2720, 15.0 / 544},
                                                   {25.0 / 24, -49.0 / 48, 125.0 / 16, -85.0 / 12}};
  static constexpr double difference[stages] = {-3.0 / 16, -27.0 / 32, 25.0 / 32, 0.0, 1.0 / 4};
};

}  // namespace glissade::block_detail
