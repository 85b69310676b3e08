// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/coupled_tables/coupled_table.hpp"

#include <algorithm>
#include <cmath>

#include "glissade/core/oscillator.hpp"

namespace glissade::block_detail {
namespace {

/// SIMD loads reach no farther beyond what is required.
constexpr std::size_t widest = 16;
/// Room for rounding in single precision.
constexpr float room = 1.0f + 0x1p-20f;

std::size_t tiles_of(std::size_t nodes) { return nodes / CoupledTable::tile + 1; }
std::size_t padded(std::size_t nodes) { return tiles_of(nodes) * CoupledTable::tile + widest; }
std::vector<float> tile_values(std::size_t nodes) {
  return std::vector<float>(tiles_of(nodes) + widest);
}

std::vector<double> vertical_or_zero(const GroundMotion& motion) {
  if (motion.vertical_mps2.empty()) return {0.0};
  return {motion.vertical_mps2.begin(), motion.vertical_mps2.end()};
}

/// A regime's exact step from node to node.
struct ResponseStep {
  double xx, xy, yx, yy, x_start, x_end, y_start, y_end;  // of the scaled state and the forcing
  double c_a, c_w;
  double* x_out;
  double* y_out;
  double x = 0.0, y = 0.0, forcing = 0.0;

  void to(std::size_t node, double a, double w) {
    const double next = c_a * a + c_w * w, x0 = x;
    x = (xx * x + xy * y) - (x_start * forcing + x_end * next);
    y = (yy * y - yx * x0) - (y_start * forcing + y_end * next);
    x_out[node] = x;
    y_out[node] = y;
    forcing = next;
  }
};

/// Side by side, since each waits for its own last step.
template <std::size_t count>
void walk(std::span<const ResponseStep> given, const double* a, const double* w,
          std::size_t nodes) {
  std::array<ResponseStep, count> steps;
  for (std::size_t k = 0; k < count; ++k) {
    steps[k] = given[k];
    steps[k].forcing = steps[k].c_a * a[0] + (w != nullptr ? steps[k].c_w * w[0] : 0.0);
  }
  for (std::size_t i = 1; i < nodes; ++i)
    for (ResponseStep& step : steps) step.to(i, a[i], w != nullptr ? w[i] : 0.0);
}

/// @param direction 0 at rest
LaneRegime lane_regime(const RegimeOscillator& r, const CoupledContact& contact, int direction) {
  const Contact& at_rest = contact.at_rest();
  const DriveLine &slide = r.contact.drive, &first = direction == 0 ? at_rest.down() : slide,
                  &second = at_rest.up();
  const double sign = direction == 0 ? 1.0 : -1.0;
  return {.mass = r.contact.mass,
          .weight = r.contact.weight,
          .lag = r.lag,
          .angle = r.angle,
          .per_angle = r.per_angle,
          .decay = r.alpha_radps * r.dt_s,
          .turn = r.beta_radps * r.dt_s,
          .sigma_re = -r.alpha_radps * r.per_omega,
          .sigma_im = r.beta_radps * r.per_omega,
          .sigma = r.phase * r.per_angle,
          .per_im = r.omega_radps * r.per_beta,
          .phase = r.phase,
          .per_omega = r.per_omega,
          .per_omega2 = r.per_omega2,
          .a_1 = sign * first.a,
          .w_1 = sign * first.w,
          .a_2 = direction == 0 ? second.a : 0.0,
          .w_2 = direction == 0 ? second.w : -1.0};
}

}  // namespace

CoupledNodes::CoupledNodes(const GroundMotion& motion)
    : a(motion.dt_s, motion.horizontal_mps2),
      w(motion.dt_s, vertical_or_zero(motion)),
      vertical(!motion.vertical_mps2.empty()),
      quiet(std::max(a.quiet_from(), vertical ? w.quiet_from() : 0)),
      tile_lowest_w_mps2(tiles_of(quiet + 1)),
      tile_highest_w_mps2(tiles_of(quiet + 1)) {
  a.extend(padded(quiet + 1));
  if (!vertical) return;
  w.extend(padded(quiet + 1));
  for (std::size_t b = 0; b < tiles_of(quiet + 1); ++b) {
    const auto values = w.acceleration_mps2().begin();
    const std::size_t first = b * CoupledTable::tile;
    const auto [lowest, highest] =
        std::minmax_element(values + static_cast<std::ptrdiff_t>(first - (b > 0 ? 1 : 0)),
                            values + static_cast<std::ptrdiff_t>(first + CoupledTable::tile));
    tile_lowest_w_mps2[b] = *lowest;
    tile_highest_w_mps2[b] = *highest;
    lowest_w_mps2 = std::min(lowest_w_mps2, *lowest);
    highest_w_mps2 = std::max(highest_w_mps2, *highest);
  }
}

CoupledTable::CoupledTable(const CoupledNodes& nodes, const CoupledContact& contact,
                           const BuildingOscillator& building, double sign, double vertical_ratio)
    : nodes_(nodes),
      sign_(sign),
      vertical_ratio_(vertical_ratio),
      gravity_mps2_(contact.gravity()),
      cot_slope_(contact.cot_slope()),
      lowest_per_g_(-contact.at_rest().down().w / contact.at_rest().down().a),
      highest_per_g_(-contact.at_rest().up().w / contact.at_rest().up().a),
      regimes_{
          RegimeOscillator(contact.stuck(), contact.gravity(), building, nodes.a.step_s()),
          RegimeOscillator(contact.sliding_down(), contact.gravity(), building, nodes.a.step_s()),
          RegimeOscillator(contact.sliding_up(), contact.gravity(), building, nodes.a.step_s())} {
  respond(building);
  for (const int direction : {-1, 0, 1}) {
    LaneRegime& lane = lane_regimes_[index(direction)];
    lane = lane_regime(regime(direction), contact, direction);
    lane.x = response(direction).x.data();
    lane.y = response(direction).y.data();
  }
  set_rest(building.damping_ratio);
  speeds_[1] = speed_of(+1);
  speeds_[2] = vertical_ratio == 0.0 && responses_[1] == responses_[2] ? speeds_[1] : speed_of(-1);
}

GroundLine CoupledTable::accelerations(double a_factor, double w_factor) const {
  return {nodes_.a.acceleration_mps2().data(),
          vertical_ratio_ != 0.0 ? nodes_.w.acceleration_mps2().data() : nullptr, a_factor,
          w_factor};
}

void CoupledTable::respond(const BuildingOscillator& building) {
  const std::size_t count = nodes_.quiet + 1;
  std::vector<ResponseStep> steps;
  for (std::size_t k = 0; k < 3; ++k) {
    const ContactRegime& contact = regimes_[k].contact;
    for (std::size_t other = 0; other < k; ++other)
      if (contact.mass == regimes_[other].contact.mass &&
          contact.weight * vertical_ratio_ == regimes_[other].contact.weight * vertical_ratio_)
        responses_[k] = responses_[other];
    if (responses_[k]) continue;
    responses_[k] = std::make_shared<Response>();
    Response& response = *responses_[k];
    response.x.resize(padded(count));
    response.y.resize(padded(count));
    // The regime's own scaled state is x / mass, y / sqrt(mass).
    const double root = std::sqrt(contact.mass);
    const OscillatorStep s = oscillator_step(building.omega_radps * nodes_.a.step_s() / root,
                                             building.damping_ratio / root);
    steps.push_back({s.xx, s.xy * root, s.xy / root, s.yy, s.x_start, s.x_end, s.y_start / root,
                     s.y_end / root, contact.mass * sign_, contact.weight * vertical_ratio_,
                     response.x.data(), response.y.data()});
  }
  const GroundLine ground = accelerations(1.0, 1.0);
  if (steps.size() == 1) walk<1>(steps, ground.a, ground.w, count);
  if (steps.size() == 2) walk<2>(steps, ground.a, ground.w, count);
  if (steps.size() == 3) walk<3>(steps, ground.a, ground.w, count);
  for (std::size_t k = 0; k < 3; ++k)
    if (responses_[k]->amplitude.empty())
      set_bounds(*responses_[k], regimes_[k], building.damping_ratio);
}

void CoupledTable::set_bounds(Response& response, const RegimeOscillator& r,
                              double damping_ratio) const {
  const std::size_t count = nodes_.quiet + 1;
  for (std::vector<float>* values : {&response.amplitude, &response.a_mps2, &response.x_mps2})
    *values = tile_values(count);
  fill_amplitude({response.x.data(), response.y.data(),
                  accelerations(r.contact.mass * sign_, r.contact.weight * vertical_ratio_), r.lag,
                  r.per_angle, r.alpha_radps / r.beta_radps, r.omega_radps / r.beta_radps,
                  r.per_mass, 2.0 * damping_ratio, response.amplitude.data(),
                  response.a_mps2.data(), response.x_mps2.data()},
                 count);
  const double per_w = r.contact.weight * vertical_ratio_, step = r.angle,
               largest_a_g = nodes_.a.peak_acceleration_mps2();
  for (std::size_t b = 0; b < tiles_of(count); ++b) {
    const double w = std::abs(per_w) *
                     std::max(-nodes_.tile_lowest_w_mps2[b], nodes_.tile_highest_w_mps2[b]),
                 a = (response.a_mps2[b] + w) / r.contact.mass +
                     0.125 * r.phase * r.phase * response.amplitude[b];
    response.a_mps2[b] = static_cast<float>(a) * room;
    response.x_mps2[b] =
        (response.x_mps2[b] + static_cast<float>(0.125 * step * step * (a + largest_a_g))) * room;
    response.largest_x_mps2 =
        std::max(response.largest_x_mps2, static_cast<double>(response.x_mps2[b]));
  }
}

LaneTables CoupledTable::lanes(const CoupledTable* yielding, const Yielding& spring) const {
  LaneTables t;
  t.ground = nodes_.a.nodes().data();
  t.vertical = nodes_.vertical ? nodes_.w.nodes().data() : nullptr;
  t.quiet = static_cast<std::int64_t>(nodes_.quiet);
  t.end = static_cast<std::int64_t>(std::min(nodes_.quiet, nodes_.a.last_sample()));
  t.sign = sign_;
  t.step_s = nodes_.a.step_s();
  t.gravity_mps2 = gravity_mps2_;
  t.cot_slope = cot_slope_;
  t.yielding_to_elastic = std::sqrt(spring.hardening_ratio);
  t.yields = spring.yields();
  t.has_yielding = yielding != nullptr;
  for (std::size_t k = 0; k < 6; ++k) {
    const CoupledTable& of = k < 3 || yielding == nullptr ? *this : *yielding;
    t.regimes[k] = &of.lane_regimes_[k % 3];
    t.decay_terms = std::max(t.decay_terms, terms_for(t.regimes[k]->decay));
    t.turn_terms = std::max(t.turn_terms, terms_for(t.regimes[k]->turn));
  }
  return t;
}

double CoupledTable::contact_margin_mps2(int direction, double intensity, double w_factor) const {
  if (cot_slope_ == never) return never;  // the condition on w alone is can_be_tabulated's
  const Response& of = response(direction);
  double least = never;
  for (std::size_t b = 0; b < nodes_.tile_lowest_w_mps2.size(); ++b)
    least = std::min(least, (gravity_mps2_ + nodes_.lowest_w(w_factor, b)) * cot_slope_ -
                                intensity * of.a_mps2[b]);
  return least;
}

void CoupledTable::set_rest(double damping_ratio) {
  const RegimeOscillator& r = regimes_[0];
  const Response& response = *responses_[0];
  const std::size_t count = nodes_.quiet + 1;
  const auto fill = [&](double per_g, std::vector<float>& values) {
    values.resize(padded(count));
    rest_.tile_below.resize(response.amplitude.size());
    rest_.tile_above.resize(response.amplitude.size());
    const double per_mass = -1.0 / r.contact.mass;
    fill_line({response.x.data(), response.y.data(), per_mass, 2.0 * damping_ratio * per_mass,
               accelerations(0.0, -per_g * vertical_ratio_), values.data(), rest_.tile_below.data(),
               rest_.tile_above.data()},
              count);
  };
  fill(highest_per_g_, rest_.above);
  if (vertical_ratio_ != 0.0) {
    const std::vector<float> tile_above = rest_.tile_above;
    fill(lowest_per_g_, rest_.below);
    rest_.tile_above = tile_above;
  } else {
    rest_.below = rest_.above;
  }
  const float deviation = static_cast<float>(0.125 * r.phase * r.phase) * room;
  for (std::size_t b = 0; b < tiles_of(count); ++b) {
    rest_.tile_below[b] -= deviation * response.amplitude[b];
    rest_.tile_above[b] += deviation * response.amplitude[b];
    rest_.largest = std::max({rest_.largest, -static_cast<double>(rest_.tile_below[b]),
                              static_cast<double>(rest_.tile_above[b])});
  }
}

std::shared_ptr<CoupledTable::Speed> CoupledTable::speed_of(int direction) const {
  const RegimeOscillator& r = regime(direction);
  const Response& of = response(direction);
  const std::size_t count = nodes_.quiet + 1;
  auto speed = std::make_shared<Speed>();
  speed->gain.resize(padded(count));
  std::vector<float> lowest = tile_values(count), highest = lowest;
  const double c_w = r.contact.drive.w / r.contact.drive.a * vertical_ratio_;
  GroundLine ground = accelerations(sign_, c_w);
  speed->tile_deviation = tile_values(count);
  fill_change(ground, speed->tile_deviation.data(), count);
  ground.a = nodes_.a.velocity_mps().data();
  if (ground.w != nullptr) ground.w = nodes_.w.velocity_mps().data();
  fill_line({of.x.data(), of.y.data(), 0.0, r.per_omega, ground, speed->gain.data(), lowest.data(),
             highest.data()},
            count);
  const float per_change = static_cast<float>(0.125 * r.dt_s) * room,
              phase = static_cast<float>(r.phase) * room;
  for (std::size_t b = 0; b < tiles_of(count); ++b) {
    speed->tile_deviation[b] = per_change * (speed->tile_deviation[b] + phase * of.amplitude[b]);
    speed->largest = std::max(
        {speed->largest, -static_cast<double>(lowest[b]), static_cast<double>(highest[b])});
  }
  return speed;
}

}  // namespace glissade::block_detail
