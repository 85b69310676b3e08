// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "block/contact/building_contact.hpp"
#include "block/full_model/building_axis.hpp"
#include "block/full_model/sdirk4.hpp"

namespace glissade::block_detail {

/// Effect of the block on an axis of the building since the start of a step.
struct Added {
  double x = 0.0, y = 0.0;
};

/// Response of an axis to that effect.
struct AxisResponse {
  double omega_radps = 0.0, twice_zeta = 0.0, stiffness = 1.0, mass_ratio = 0.0;
};

struct BuildingStep {
  ContactState end;
  std::array<Added, 2> added{};
  Axes added_rate{};   ///< of added.y, at the end
  double error = 0.0;  ///< of end.v, estimated
};

/// Motion of the uncoupled roof at the stages of a step.
struct StageLoads {
  double e[2][Sdirk4::stages];
  double w[Sdirk4::stages];
};

/// SDIRK4 of block and building together. The response of the building alone is
/// exact (`loads`); only the effect of the block is integrated, xi'' + 2 zeta omega xi' + k xi =
/// -interaction. In a stage xi follows from the interaction in closed form, which only changes e
/// and R:
///   a = [e + b / (1 + beta)] - interaction / (1 + beta),   beta = gamma_h omega (2 zeta + k
///   gamma_h omega)
/// By the balance of momentum an error in xi' is m/M times that in v, so v alone is controlled.
template <bool kCoupled>
BuildingStep building_sdirk4(Vector v, Vector guess, double length_s, double permitted_error,
                             const StageLoads& loads, const BuildingContact& contact,
                             const std::array<AxisResponse, 2>& axes, const Accelerance& at_once) {
  using S = Sdirk4;
  const double gamma_h = S::gamma * length_s;
  double spring[2] = {}, per_stage_mass[2] = {};
  Accelerance accelerance;
  if constexpr (kCoupled) {
    for (std::size_t n = 0; n < 2; ++n) {
      const double phase = gamma_h * axes[n].omega_radps;
      spring[n] = axes[n].twice_zeta + axes[n].stiffness * phase;
      per_stage_mass[n] = 1.0 / (1.0 + phase * spring[n]);
    }
    accelerance = contact.accelerance(
        {axes[0].mass_ratio * per_stage_mass[0], axes[1].mass_ratio * per_stage_mass[1]});
  }

  BuildingStep step;
  Added rate[S::stages][2];
  const auto stage = [&](int i, Vector known, double) __attribute__((always_inline)) {
    Axes e{loads.e[0][i], loads.e[1][i]};
    if constexpr (kCoupled) {
      Added before[2];
      Axes rest{};  // of xi's own forces
      for (std::size_t n = 0; n < 2; ++n) {
        for (int j = 0; j < i; ++j) {
          before[n].x += S::a[i][j] * rate[j][n].x;
          before[n].y += S::a[i][j] * rate[j][n].y;
        }
        before[n].x *= length_s;
        before[n].y *= length_s;
        rest[n] = -(axes[n].stiffness * before[n].x + spring[n] * before[n].y) * per_stage_mass[n];
        e[n] += rest[n];
      }
      step.end = contact.slide(known, gamma_h, e, loads.w[i], accelerance, guess, permitted_error);
      for (std::size_t n = 0; n < 2; ++n) {
        rate[i][n].y = axes[n].omega_radps * (rest[n] - step.end.interaction[n]);
        step.added_rate[n] = rate[i][n].y;
        step.added[n].y = before[n].y + gamma_h * rate[i][n].y;
        rate[i][n].x = axes[n].omega_radps * step.added[n].y;
        step.added[n].x = before[n].x + gamma_h * rate[i][n].x;
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
