// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/motion/simulation/gulerce_abrahamson.hpp"

#include <algorithm>
#include <cmath>

#include "glissade/motion/simulation/bssa14.hpp"
#include "gulerce_abrahamson_coefficients.hpp"
#include "period_table.hpp"

namespace glissade {
namespace {

/// The Vs30 beyond which the site term is constant.
double site_limit_mps(double period_s) {
  if (period_s <= 0.5) return 1500.0;
  if (period_s <= 1.0) return std::exp(8.0 - 0.795 * std::log(period_s / 0.21));
  if (period_s < 2.0) return std::exp(6.76 - 0.297 * std::log(period_s));
  return 700.0;
}

double log_ratio(const GulerceAbrahamsonRow& k, const Scenario& scenario, double rock_pga_g) {
  const double m = scenario.magnitude;
  const double near = std::log(std::hypot(scenario.distance_km, 10.0));
  const double source = k.a1 + k.a8 * (8.5 - m) * (8.5 - m) +
                        (m < 6.75 ? 0.0334 : -0.034) * (m - 6.75) +
                        (scenario.mechanism == FaultMechanism::reverse ? k.a6 : 0.0);
  const double path = (k.a2 + 0.0147 * (m - 6.75)) * near;

  constexpr double c = 1.88, n = 1.18;
  const double r = std::min(scenario.vs30_mps, site_limit_mps(k.period_s)) / k.vlin_mps;
  const double site = r < 1.0 ? k.a10 * std::log(r) + k.b * std::log(rock_pga_g + c) -
                                    k.b * std::log(rock_pga_g + c * std::pow(r, n))
                              : (k.a10 - k.b * n) * std::log(r);
  return source + path + site;
}

}  // namespace

double vertical_to_horizontal_ratio(const Scenario& scenario, double period_s) {
  Scenario rock = scenario;
  rock.vs30_mps = 1100.0;
  const double rock_pga_g = bssa14_median_sa_g(rock, 0.0);
  const auto [below, above, weight] =
      bracket_period(std::span<const GulerceAbrahamsonRow>(gulerce_abrahamson_rows), period_s);
  return std::exp(std::lerp(log_ratio(below, scenario, rock_pga_g),
                            log_ratio(above, scenario, rock_pga_g), weight));
}

}  // namespace glissade
