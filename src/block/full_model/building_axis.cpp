// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/full_model/building_axis.hpp"

#include <numbers>
#include <vector>

#include "block/full_model/chord_deviation.hpp"
#include "glissade/building/rigid.hpp"

namespace glissade::block_detail {

Modes responding(const Modes& modes, double dt_s) {
  std::vector<Mode> moving;
  for (const Mode& mode : modes)
    if (!is_rigid(mode.oscillator(), dt_s)) moving.push_back(mode);
  if (moving.empty()) return {};
  std::vector<Mode> at_array = moving;
  std::erase_if(at_array, [](const Mode& mode) { return mode.participation == 0.0; });
  const bool one_mass = at_array.size() == 1 && Modes(at_array).is_one_mass();
  return Modes(one_mass ? at_array : moving);
}

BuildingAxis::BuildingAxis(const Modes& modes, const Yielding& yielding, double mass_ratio,
                           double piece_s)
    : mass_ratio_(mass_ratio), stuck_mass_(1.0 + mass_ratio) {
  if (modes.rigid()) return;
  size_ = modes.size();
  one_mass_ = modes.is_one_mass();
  const double per_force = modes.accelerance();
  ground_share_ = modes.ground_share();
  accelerance_ = mass_ratio * per_force;
  stuck_mass_ = 1.0 + accelerance_;
  if (per_force > 0.0) shear_per_interaction_ = ground_share_ / per_force;
  double rate = 0.0;  // the largest
  for (std::size_t n = 0; n < size_; ++n) {
    AxisMode& mode = modes_[n];
    const Mode& of = modes[n];
    mode.omega_radps = 2.0 * std::numbers::pi / of.period_s;
    mode.twice_zeta = 2.0 * of.damping_ratio;
    mode.participation = of.participation;
    mode.mass_share = of.mass_share;
    mass_left_out_ -= of.mass_share;
    mode.kappa = per_force > 0.0 ? of.participation / (of.mass_share * per_force) : 0.0;
    const double slower = modes_[0].omega_radps / mode.omega_radps;
    mode.roof_per_x = of.participation * (slower * slower);
    rate = std::max(rate, mode.omega_radps * piece_s * (1.0 + mode.twice_zeta));
  }
  constexpr double last_term = 1e-15;  // of the first: far below the least tolerance, 1e-11
  int terms = 3;
  for (double term = rate * rate * rate / 6.0; term > last_term && terms < Series::most_terms - 3;)
    term *= rate / ++terms;
  terms_ = terms + 1;
  if (!one_mass_) return;

  yields_ = yielding.yields();
  if (yields_) {
    hardening_ = yielding.hardening_ratio;
    yield_ = yielding.yield_acceleration_mps2;
  }
  phase_ = omega_radps() * piece_s;
  rest_ = oscillator_step(phase_, modes[0].damping_ratio, stuck_mass_, std::sqrt(stuck_mass_));
}

double BuildingAxis::resisting(double ground) const {
  if (rigid()) return stuck_mass_ * ground;
  if (one_mass_) return -(twice_zeta() * y() + spring());
  double e = ground_share_ * ground;
  for (const AxisMode& mode : modes())
    e -= mode.participation * (mode.twice_zeta * mode.y + mode.x);
  return e;
}

// In the fraction of the piece, with phase = omega length:
//   dx = phase y,  dy = phase (E_n - kappa (E - a) - a_ground),  mass a = E - interaction,
//   dE_n = -(2 zeta dy + k dx).
template <bool kOneMass>
void BuildingAxis::expand(AxisSeries& m, double length_s, const double (&ground)[2], double mass,
                          const double (&interaction)[2]) const {
  const std::size_t count = kOneMass ? 1 : size_;
  const double per_mass = 1.0 / mass, k_tangent = kOneMass ? stiffness() : 1.0;
  double phase[most_modes], e[most_modes];
  for (std::size_t n = 0; n < count; ++n) {
    const AxisMode& mode = modes_[n];
    phase[n] = mode.omega_radps * length_s;
    m.x[n].terms = m.y[n].terms = terms_;
    m.x[n].c[0] = mode.x;
    m.y[n].c[0] = mode.y;
    e[n] = -(mode.twice_zeta * mode.y + (kOneMass ? spring() : mode.x));
  }
  if constexpr (!kOneMass) m.shear.terms = m.roof_x.terms = terms_;
  for (int k = 0; k < terms_; ++k) {
    double roof = e[0];
    if constexpr (!kOneMass) {
      roof = k < 2 ? ground_share_ * ground[k] : 0.0;
      double shear = k < 2 ? mass_left_out_ * ground[k] : 0.0, x = 0.0;
      for (std::size_t n = 0; n < count; ++n) {
        roof += modes_[n].participation * e[n];
        shear += modes_[n].mass_share * e[n];
        x += modes_[n].roof_per_x * m.x[n].c[k];
      }
      const double reduced = (1.0 - per_mass) * roof + (k < 2 ? interaction[k] * per_mass : 0.0);
      m.shear.c[k] = shear + shear_per_interaction_ * reduced;
      m.roof_x.c[k] = x;
    }
    m.resisting.c[k] = roof;
    if (k + 1 == terms_) break;
    const double a = roof * per_mass;
    for (std::size_t n = 0; n < count; ++n) {
      const AxisMode& mode = modes_[n];
      const double factor = phase[n] * Series::inverse[k + 1];
      double rise = kOneMass ? a : e[n] - mode.kappa * (roof - a);
      if (k < 2) rise -= ground[k] + (kOneMass ? 1.0 : mode.kappa) * (interaction[k] * per_mass);
      const double x = factor * m.y[n].c[k], y = factor * rise;
      m.x[n].c[k + 1] = x;
      m.y[n].c[k + 1] = y;
      e[n] = -(mode.twice_zeta * y + k_tangent * x);
    }
  }
}

AxisSeries BuildingAxis::motion(double length_s, const Ramp& ground, double mass,
                                const Ramp& interaction) const {
  AxisSeries m;
  const double ground_c[2] = {ground.begin, ground.end - ground.begin},
               interaction_c[2] = {interaction.begin, interaction.end - interaction.begin};
  m.resisting.terms = terms_;
  if (rigid()) {
    m.x[0].terms = m.y[0].terms = terms_;
    for (int k = 0; k < 2; ++k) {
      m.x[0].c[k] = m.y[0].c[k] = 0.0;
      m.resisting.c[k] = mass * ground_c[k] + interaction_c[k];
    }
    m.resisting_bound = std::abs(m.resisting.c[0]) + std::abs(m.resisting.c[1]);
    return m;
  }
  if (!one_mass_) {
    expand<false>(m, length_s, ground_c, mass, interaction_c);
    m.resisting_bound = m.resisting.bound();
    m.shear_bound = m.shear.bound();
    m.x_bound = m.roof_x.bound();
    return m;
  }
  expand<true>(m, length_s, ground_c, mass, interaction_c);
  // Bounds by the first four terms. From the fourth on, |E_k+1| <= (2 zeta phase / k) |E_k| +
  // (phase^2 / (k (k - 1))) |E_k-1| and x_k+2 is phase^2 / (k + 1) (k + 2) of E_k, with phase (1 +
  // 2 zeta) <= longest_phase = 0.4.
  constexpr double tail_of_e2 = 1.02;  // of E_2 and all it adds to later terms: 1 + 0.4^2 / 12 ...
  constexpr double tail_of_e3 = 1.13;  // of E_3: 1 + 0.4 / 4 + 0.4^2 / 20 ...
  constexpr double x_per_e = 0.0134;   // 0.4^2 / 12
  const auto size = [](const Series& of, int k) { return std::abs(coefficient(of, k)); };
  const Series& x = m.x[0];
  const double e2 = tail_of_e2 * size(m.resisting, 2), e3 = tail_of_e3 * size(m.resisting, 3);
  m.resisting_bound = size(m.resisting, 0) + size(m.resisting, 1) + e2 + e3;
  m.x_bound = size(x, 0) + size(x, 1) + size(x, 2) + size(x, 3) + x_per_e * (e2 + e3);
  return m;
}

RestMap BuildingAxis::rest_map(double piece_s) const {
  RestMap map;
  map.states = 2 * size_;
  for (std::size_t j = 0; j < map.states + 2; ++j) {
    BuildingAxis unit = *this;
    for (std::size_t n = 0; n < size_; ++n) {
      unit.modes_[n].x = 2 * n == j ? 1.0 : 0.0;
      unit.modes_[n].y = 2 * n + 1 == j ? 1.0 : 0.0;
    }
    const AxisSeries m = unit.motion(
        piece_s, {j == map.states ? 1.0 : 0.0, j == map.states + 1 ? 1.0 : 0.0}, stuck_mass_);
    for (std::size_t n = 0; n < size_; ++n) {
      map.next[2 * n][j] = m.x[n].at(1.0);
      map.next[2 * n + 1][j] = m.y[n].at(1.0);
    }
    const Series& e = m.resisting;
    map.e_begin[j] = e.c[0];
    map.e_end[j] = e.at(1.0);
    map.e_deviation[j] = chord_deviation({e.c.data(), static_cast<std::size_t>(e.terms)});
    map.shear[j] = (one_mass_ ? e : m.shear).bound();
    map.roof_x[j] = (one_mass_ ? m.x[0] : m.roof_x).bound();
  }
  return map;
}

RestMap::Row BuildingAxis::rest_row(const Ramp& ground) const {
  RestMap::Row row;
  for (std::size_t n = 0; n < size_; ++n) {
    row[2 * n] = modes_[n].x;
    row[2 * n + 1] = modes_[n].y;
  }
  row[2 * size_] = ground.begin;
  row[2 * size_ + 1] = ground.end;
  return row;
}

void BuildingAxis::rest_on(const RestMap& map, const RestMap::Row& row) {
  for (std::size_t n = 0; n < size_; ++n) {
    modes_[n].x = map.value(map.next[2 * n], row);
    modes_[n].y = map.value(map.next[2 * n + 1], row);
  }
}

double BuildingAxis::next_yield(const AxisSeries& motion) const {
  if (!yields_) return never;
  if (yield_direction_ != 0)
    return first_fall(motion.y[0], yield_direction_ > 0 ? Sign::plus : Sign::minus);
  Series z = motion.x[0];
  z.c[0] = z_ - yield_;
  const double up = first_rise(z);
  z.c[0] = z_ + yield_;
  return std::min(up, first_fall(z));
}

void BuildingAxis::follow(const AxisSeries& motion, double fraction, const Added* added) {
  const double x_before = x();
  for (std::size_t n = 0; n < size_; ++n) {
    const Added add = added != nullptr ? added[n] : Added{};
    modes_[n].x = motion.x[n].at(fraction) + add.x;
    modes_[n].y = motion.y[n].at(fraction) + add.y;
  }
  if (yields_ && yield_direction_ == 0) z_ = std::clamp(z_ + (x() - x_before), -yield_, yield_);
}

void BuildingAxis::yield() {
  if (yield_direction_ != 0) {
    double& y = modes_[0].y;
    y = yield_direction_ > 0 ? std::min(y, 0.0) : std::max(y, 0.0);
    yield_direction_ = 0;
    return;
  }
  yield_direction_ = z_ > 0.0 ? 1 : -1;
  z_ = yield_direction_ * yield_;
}

double BuildingAxis::largest_to_come_mps2() const {
  if (yield_direction_ != 0) return never;
  if (!one_mass_ && mass_ratio_ > 0.0) return largest_by_energy_mps2();
  double sum = 0.0;
  for (const AxisMode& mode : modes()) {
    const double s = one_mass_ ? spring() : mode.x, root = std::sqrt(stuck_mass_),
                 zeta = 0.5 * mode.twice_zeta / root;
    const Envelope envelope = free_vibration_envelope(s / stuck_mass_, mode.y / root, zeta);
    // Elastic about where the spring is without force.
    if (yields_ && !(std::abs(z_ - s) + stuck_mass_ * envelope.amplitude < yield_)) return never;
    sum += std::abs(mode.participation) * ((1.0 + 2.0 * zeta) * envelope.amplitude);
  }
  return sum;
}

/// The array couples the modes; the energy of all, with the array's, does not grow, and the worst
/// is that it is all where it accelerates the roof most:
///   2 energy / M = sum of e (x^2 + y^2) / omega^2 + m/M (sum of gamma y / omega)^2
double BuildingAxis::largest_by_energy_mps2() const {
  double energy2 = 0.0, roof_speed = 0.0, per_energy = 0.0;
  for (const AxisMode& mode : modes()) {
    const double omega2 = mode.omega_radps * mode.omega_radps;
    energy2 += mode.mass_share * (mode.x * mode.x + mode.y * mode.y) / omega2;
    roof_speed += mode.participation * mode.y / mode.omega_radps;
    per_energy += mode.participation * mode.participation / mode.mass_share * omega2 *
                  (1.0 + mode.twice_zeta * mode.twice_zeta);
  }
  return std::sqrt((energy2 + mass_ratio_ * roof_speed * roof_speed) * per_energy) / stuck_mass_;
}

}  // namespace glissade::block_detail
