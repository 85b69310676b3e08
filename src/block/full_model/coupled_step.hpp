// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "block/contact/building_contact.hpp"
#include "block/full_model/building_axis.hpp"
#include "block/full_model/sdirk4.hpp"

namespace glissade::block_detail {

struct BuildingStep {
  ContactState end;
  std::array<std::array<Added, most_modes>, 2> added;        ///< by axis and mode
  std::array<std::array<double, most_modes>, 2> added_rate;  ///< of added.y, at the end
  double error = 0.0;                                        ///< of end.v, estimated
};

/// Motion of the uncoupled roof at the stages of a step.
struct StageLoads {
  double e[2][Sdirk4::stages];
  double w[Sdirk4::stages];
};

/// SDIRK4 of block and building together. The response of the building alone is exact (`loads`);
/// only the effect of the block is integrated: of each mode xi'' + 2 zeta omega xi' + k xi = -kappa
/// interaction. In a stage xi follows from the interaction in closed form, which only changes e and
/// R; with beta = gamma_h omega (2 zeta + k gamma_h omega) and the sums over modes,
///   a = [e + sum of gamma b / (1 + beta)] - W interaction,   W = sum of gamma kappa / (1 + beta)
/// By the balance of momentum an error in xi' is m/M times that in v, so v alone is controlled.
/// @param most_of_axis modes at most; 0: the roof is not coupled with the block
template <std::size_t most_of_axis>
BuildingStep building_sdirk4(Vector v, Vector guess, double length_s, double permitted_error,
                             const StageLoads& loads, const BuildingContact& contact,
                             const std::array<BuildingAxis, 2>& axes, const Accelerance& at_once) {
  using S = Sdirk4;
  constexpr std::size_t most = std::max<std::size_t>(most_of_axis, 1);
  const double gamma_h = S::gamma * length_s;
  double spring[2][most] = {}, per_stage_mass[2][most] = {};
  double share[2][most] = {};  // of the interaction in a
  std::size_t count[2] = {};
  Accelerance accelerance;
  if constexpr (most_of_axis > 0) {
    Axes ratio{};
    for (std::size_t n = 0; n < 2; ++n) {
      count[n] = std::min(most, axes[n].modes().size());
      double total = 0.0;
      for (std::size_t k = 0; k < count[n]; ++k) {
        const AxisMode& mode = axes[n].modes()[k];
        const double phase = gamma_h * mode.omega_radps;
        spring[n][k] = mode.twice_zeta + axes[n].stiffness() * phase;
        per_stage_mass[n][k] = 1.0 / (1.0 + phase * spring[n][k]);
        share[n][k] = mode.kappa * per_stage_mass[n][k];
        total += mode.gain() * per_stage_mass[n][k];
      }
      for (std::size_t k = 0; k < count[n] && total > 0.0; ++k) share[n][k] /= total;
      ratio[n] = at_once.axis[n] * total;
    }
    accelerance = contact.accelerance(ratio);
  }

  BuildingStep step;
  Added rate[S::stages][2][most];
  const auto stage = [&](int i, Vector known, double) __attribute__((always_inline)) {
    Axes e{loads.e[0][i], loads.e[1][i]};
    if constexpr (most_of_axis > 0) {
      Added before[2][most];
      double rest[2][most];  // of xi's own forces
      for (std::size_t n = 0; n < 2; ++n) {
        for (std::size_t k = 0; k < count[n]; ++k) {
          const AxisMode& mode = axes[n].modes()[k];
          Added& b = before[n][k];
          for (int j = 0; j < i; ++j) {
            b.x += S::a[i][j] * rate[j][n][k].x;
            b.y += S::a[i][j] * rate[j][n][k].y;
          }
          b.x *= length_s;
          b.y *= length_s;
          rest[n][k] = -(axes[n].stiffness() * b.x + spring[n][k] * b.y) * per_stage_mass[n][k];
          e[n] += mode.participation * rest[n][k];
        }
      }
      step.end = contact.slide(known, gamma_h, e, loads.w[i], accelerance, guess, permitted_error);
      for (std::size_t n = 0; n < 2; ++n) {
        for (std::size_t k = 0; k < count[n]; ++k) {
          const double omega = axes[n].modes()[k].omega_radps;
          const Added& b = before[n][k];
          Added &added = step.added[n][k], &r = rate[i][n][k];
          r.y = omega * (rest[n][k] - share[n][k] * step.end.interaction[n]);
          step.added_rate[n][k] = r.y;
          added.y = b.y + gamma_h * r.y;
          r.x = omega * added.y;
          added.x = b.x + gamma_h * r.x;
        }
      }
      guess = step.end.friction;
    } else {
      step.end =
          contact.slide_uncoupled(known, gamma_h, contact.loading().at(e[0], e[1], loads.w[i]));
    }
    return step.end.a;
  };
  step.error = sdirk4(v, length_s, contact.friction(), stage, [&] {
                 return step.end.normal * (1.0 + at_once.mean);
               }).error;
  return step;
}

}  // namespace glissade::block_detail
