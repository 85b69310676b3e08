// SPDX-License-Identifier: GPL-3.0-or-later
//
// The roof under a block, and its load, over the rest of a sample interval as power series.
// Included once per SIMD target.
#if defined(GLISSADE_TWO_AXES_ROOF_SERIES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef GLISSADE_TWO_AXES_ROOF_SERIES_INL
#undef GLISSADE_TWO_AXES_ROOF_SERIES_INL
#else
#define GLISSADE_TWO_AXES_ROOF_SERIES_INL
#endif

#include <type_traits>

#include "block/two_axes/lanes/numbers-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace glissade::block_detail::two_axes::HWY_NAMESPACE {

/// A quantity linear over the rest of the interval.
struct Ramped {
  V begin, rise;
};

/// The series of a roof of modes over a sample interval, of the lanes' own tables.
struct TableRow {
  const double* nodes;
  hn::Vec<Indices> at;

  template <std::size_t axis, int k>
  HWY_INLINE V Term() const {
    return hn::GatherIndex(Doubles(), nodes + (axis * row_terms + k), at);
  }
};

/// Of a building of several modes.
struct ModeSeries {
  V x[2][most_modes][roof_order + 1], y[2][most_modes][roof_order + 1], phase[2][most_modes];

  HWY_INLINE ModeSeries() {}  // an implicit one is not compiled for the target (GCC, Arm)
};
struct NoModes {};

/// Series in tau, the fraction of the rest of the interval that has passed; h is its length. The
/// roof under a block whose velocity is given by its first terms, and the load, times h.
template <RoofKind roof, int velocity_terms, int load_terms>
class RoofSeries {
  static constexpr bool of_modes = roof == RoofKind::coupled_modes;

 public:
  V v_s[velocity_terms], v_y[velocity_terms];
  V x_1[roof_order + 1], y_1[roof_order + 1], x_2[roof_order + 1], y_2[roof_order + 1];
  std::conditional_t<of_modes, ModeSeries, NoModes> modes;
  V rate_1[roof_order], rate_2[roof_order];  // y without the block's part, where the roof yields
  V a_1[roof_order], a_2[roof_order];  // the roof, as far as the block's own rate has no part in it
  V p_s[load_terms], p_y[load_terms];  // load
  V weight[load_terms];                // n on a roof that the block does not accelerate

  HWY_INLINE RoofSeries(const LaneStates& states, Here lanes, const Ramped& first,
                        const Ramped& second, const Ramped& vertical, const TableRow& row, V length)
      : c(states.constants),
        of(states.mode_constants),
        here(lanes),
        h(length),
        count(states.modes),
        ground_1(first),
        ground_2(second),
        up(vertical) {
    const LaneMotion<Rows>& m = states.motion;
    v_s[0] = here(m.v_s);
    v_y[0] = here(m.v_y);
    h_c = h * here(c.c);
    h_s = h * here(c.s);
    h_c_across = h * here(c.c_across);
    h_s_across = h * here(c.s_across);
    if constexpr (is_one_mass_with_block(roof)) {
      b_1s = here(c.omega_rho_1) * (here(c.c) * here(c.cosine2));
      b_1y = here(c.omega_rho_1) * (here(c.s) * here(c.cosine));
      b_2s = here(c.omega_rho_2) * (here(c.s) * here(c.cosine2));
      b_2y = here(c.omega_rho_2) * (here(c.c) * here(c.cosine));
    }
    if constexpr (roof == RoofKind::modes) {
      Read<0>(row, here(c.factor_1), here(m.left), a_1);
      Read<1>(row, here(c.factor_2), here(m.left), a_2);
    }
    if constexpr (of_modes) {
      b_1s = here(c.c) * here(c.cosine2);
      b_1y = here(c.s) * here(c.cosine);
      b_2s = here(c.s) * here(c.cosine2);
      b_2y = here(c.c) * here(c.cosine);
      for (std::size_t axis = 0; axis < 2; ++axis)
        for (std::size_t n = 0; n < count; ++n) {
          modes.x[axis][n][0] = here(states.mode_motion.x[axis][n]);
          modes.y[axis][n][0] = here(states.mode_motion.y[axis][n]);
          modes.phase[axis][n] = here(of.omega[axis][n]) * h;
        }
    } else if constexpr (has_state(roof)) {
      phase_1 = here(c.omega_1) * h;
      phase_2 = here(c.omega_2) * h;
      if constexpr (roof == RoofKind::yielding) {
        spring_phase_1 = phase_1 * Stiffness(states, 0);
        spring_phase_2 = phase_2 * Stiffness(states, 1);
      }
      x_1[0] = here(m.x_1);
      y_1[0] = here(m.y_1);
      x_2[0] = here(m.x_2);
      y_2[0] = here(m.y_2);
    }
  }

  /// The term k of the load, by those of the velocity up to it.
  template <int k>
  HWY_INLINE void Term() {
    if constexpr (has_state(roof)) Respond<k>();
    if constexpr (k < load_terms) Load<k>();
  }

 protected:
  const Constants<Rows>& c;
  const ModeConstants<Rows>& of;
  Here here;
  V h;
  std::size_t count;  // of modes

 private:
  const Ramped &ground_1, &ground_2, &up;
  V phase_1, phase_2, spring_phase_1, spring_phase_2;
  V h_c, h_s, h_c_across, h_s_across;
  V b_1s, b_1y, b_2s, b_2y;  // from the block's velocity to its effect on the building's axes

  /// The acceleration of an axis over the rest of the interval.
  template <std::size_t axis>
  HWY_INLINE void Read(const TableRow& row, V factor, V left, V (&a)[roof_order]) {
    const V one = Number(1.0);
    if (hn::AllTrue(Doubles(), hn::Eq(left, one))) {
      ForOrders<0, load_terms>([&](auto k)
                                   GLISSADE_INLINE_LAMBDA { a[k] = factor * row.Term<axis, k>(); });
      return;
    }
    ForOrders<0, roof_order>([&](auto k) GLISSADE_INLINE_LAMBDA { a[k] = row.Term<axis, k>(); });
    // Horner's shift to what has passed, then a change of scale.
    const V passed = one - left;
    ForOrders<0, load_terms>([&](auto i) GLISSADE_INLINE_LAMBDA {
      ForOrders<0, roof_order - 1 - i>([&](auto j) GLISSADE_INLINE_LAMBDA {
        constexpr int k = roof_order - 2 - j;
        a[k] = a[k] + passed * a[k + 1];
      });
    });
    V scale = factor;
    ForOrders<0, load_terms>([&](auto k) GLISSADE_INLINE_LAMBDA {
      a[k] = scale * a[k];
      scale = scale * left;
    });
  }

  /// Of a spring, over that of the elastic one.
  HWY_INLINE V Stiffness(const LaneStates& states, std::size_t axis) const {
    const Mask elastic = hn::Eq(here(states.spring_motion.direction[axis]), hn::Zero(Doubles()));
    return hn::IfThenElse(elastic, Number(1.0), here(states.spring_constants.hardening[axis]));
  }

  /// One axis of the building, and its acceleration as far as the block's own
  /// has no part in it.
  template <int k>
  HWY_INLINE void Respond(V* x, V* y, V* a, V* rates, V phase, V spring_phase, V twice_zeta,
                          V block_velocity, const Ramped& ground) {
    V rate = y[k];
    if constexpr (is_one_mass_with_block(roof) && k < velocity_terms) rate = rate - block_velocity;
    a[k] = hn::Neg(twice_zeta * rate + x[k]);
    if constexpr (is_one_mass_with_block(roof)) a[k] = a[k] * here(c.per_mass);
    const V factor = phase * Number(inverse[k + 1]);
    if constexpr (roof == RoofKind::yielding) {
      rates[k] = rate;
      x[k + 1] = (spring_phase * Number(inverse[k + 1])) * rate;
    } else {
      x[k + 1] = factor * rate;
    }
    V rise = a[k];
    if constexpr (k == 0) rise = rise - ground.begin;
    if constexpr (k == 1) rise = rise - ground.rise;
    y[k + 1] = factor * rise;
  }

  /// The same of all modes of an axis: with x, Y, E_n times gamma, E the sum of E_n and of what
  /// moves with the ground,
  ///   x' = omega (Y - omega share b),   Y' = omega (E_n - share E - gamma a_ground),
  ///   E_n = -(2 zeta (Y - omega share b) + x),   a = (1 - rho) E
  template <int k>
  HWY_INLINE void RespondModes(std::size_t axis, V* a, V block_velocity, const Ramped& ground) {
    V e[most_modes];
    V sum = hn::Zero(Doubles()), forcing = sum;
    if constexpr (k < 2) {
      forcing = k == 0 ? ground.begin : ground.rise;
      sum = here(of.ground_share[axis]) * forcing;
    }
    for (std::size_t n = 0; n < count; ++n) {
      V rate = modes.y[axis][n][k];
      if constexpr (k < velocity_terms)
        rate = rate - here(of.omega_share[axis][n]) * block_velocity;
      e[n] = hn::Neg(here(of.twice_zeta[axis][n]) * rate + modes.x[axis][n][k]);
      sum = sum + e[n];
      modes.x[axis][n][k + 1] = (modes.phase[axis][n] * Number(inverse[k + 1])) * rate;
    }
    for (std::size_t n = 0; n < count; ++n) {
      V rise = e[n] - here(of.share[axis][n]) * sum;
      if constexpr (k < 2) rise = rise - here(of.gamma[axis][n]) * forcing;
      modes.y[axis][n][k + 1] = (modes.phase[axis][n] * Number(inverse[k + 1])) * rise;
    }
    a[k] = here(of.per_mass[axis]) * sum;
  }

  template <int k>
  HWY_INLINE void Respond() {
    V block_rate_1 = hn::Zero(Doubles()), block_rate_2 = block_rate_1;
    if constexpr (has_mass(roof) && k < velocity_terms) {
      block_rate_1 = b_1s * v_s[k] - b_1y * v_y[k];
      block_rate_2 = b_2s * v_s[k] + b_2y * v_y[k];
    }
    if constexpr (of_modes) {
      RespondModes<k>(0, a_1, block_rate_1, ground_1);
      RespondModes<k>(1, a_2, block_rate_2, ground_2);
      return;
    }
    Respond<k>(x_1, y_1, a_1, rate_1, phase_1, spring_phase_1, here(c.twice_zeta_1), block_rate_1,
               ground_1);
    Respond<k>(x_2, y_2, a_2, rate_2, phase_2, spring_phase_2, here(c.twice_zeta_2), block_rate_2,
               ground_2);
  }

  template <int k>
  HWY_INLINE void Load() {
    if constexpr (roof == RoofKind::rigid && k < 2) {
      a_1[k] = k == 0 ? ground_1.begin : ground_1.rise;
      a_2[k] = k == 0 ? ground_2.begin : ground_2.rise;
    }
    if constexpr (roof == RoofKind::rigid && k > 1) {
      p_s[k] = p_y[k] = weight[k] = hn::Zero(Doubles());
      return;
    }
    const V along = h_c * a_1[k] + h_s * a_2[k];
    p_y[k] = h_s_across * a_1[k] - h_c_across * a_2[k];
    if constexpr (k < 2) {
      const V fall = h * (k == 0 ? here(c.gravity) + up.begin : up.rise);
      p_s[k] = fall * here(c.tangent) - along;
      weight[k] = here(c.mu) * (fall + here(c.tangent) * along);
    } else {
      p_s[k] = hn::Neg(along);
      weight[k] = (here(c.mu) * here(c.tangent)) * along;
    }
  }
};

}  // namespace glissade::block_detail::two_axes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // GLISSADE_TWO_AXES_ROOF_SERIES_INL
