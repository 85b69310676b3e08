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

std::size_t tiles_of(std::size_t nodes) {
  return (nodes + CoupledTable::tile - 1) / CoupledTable::tile;
}
std::size_t padded(std::size_t nodes) { return tiles_of(nodes) * CoupledTable::tile + widest; }

std::vector<double> vertical_or_zero(const GroundMotion& motion) {
  if (motion.vertical_mps2.empty()) return {0.0};
  return {motion.vertical_mps2.begin(), motion.vertical_mps2.end()};
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

void CoupledTable::tabulate(const CoupledNodes& nodes, const CoupledContact& contact,
                            const BuildingOscillator& building, double sign,
                            double vertical_ratio) {
  nodes_ = &nodes;
  sign_ = sign;
  vertical_ratio_ = vertical_ratio;
  gravity_mps2_ = contact.gravity();
  cot_slope_ = contact.cot_slope();
  lowest_per_g_ = -contact.at_rest().down().w / contact.at_rest().down().a;
  highest_per_g_ = -contact.at_rest().up().w / contact.at_rest().up().a;
  const std::array<ContactRegime, 3> regimes{contact.stuck(), contact.sliding_down(),
                                             contact.sliding_up()};
  const std::size_t count = nodes.quiet + 1, all = tiles_of(count) * tile;
  TableFill fill{.ground = nodes.a.nodes().data(),
                 .vertical = vertical() ? nodes.w.nodes().data() : nullptr,
                 .twice_zeta = 2.0 * building.damping_ratio,
                 .nodes = count};
  for (std::size_t k = 0; k < 3; ++k) {
    regimes_[k] = {regimes[k], contact.gravity(), building, nodes.a.step_s()};
    set_response(k, building, fill);
  }
  const auto line = [&](Numbers<float>& values, Numbers<float>& lowest, Numbers<float>& highest) {
    return LineFill{.values = values.room(all),
                    .tile_lowest = lowest.room(tiles_of(count)),
                    .tile_highest = highest.room(tiles_of(count))};
  };
  for (std::size_t k = 0; k < 2; ++k) {  // below, above
    if (k == 0 && !vertical()) continue;
    Numbers<float>& unused = extremes_[k];
    LineFill& f = fill.rest[k] = k == 0 ? line(rest_.below, rest_.tile_below, unused)
                                        : line(rest_.above, unused, rest_.tile_above);
    if (!vertical()) f.tile_lowest = rest_.tile_below.room(tiles_of(count));
    f.x_factor = -regimes_[0].per_mass;
    f.y_factor = f.x_factor * fill.twice_zeta;
    f.w_factor = -(k == 0 ? lowest_per_g_ : highest_per_g_) * vertical_ratio_;
  }
  for (std::size_t k = 1; k < 3; ++k) {
    if (speed_source(k) != k) continue;
    LineFill& f = fill.speeds[k - 1] =
        line(speeds_[k - 1].gain, extremes_[2 * k], extremes_[2 * k + 1]);
    f.tile_change = speeds_[k - 1].tile_deviation.room(tiles_of(count));
    f.y_factor = regimes_[k].per_omega;
    f.a_factor = sign_;
    f.w_factor = regimes_[k].contact.drive.w / regimes_[k].contact.drive.a * vertical_ratio_;
  }
  fill_tables(fill);
  for (std::size_t k = 0; k < 3; ++k)
    if (source_[k] == k) set_bounds(responses_[k], regimes_[k]);
  set_rest();
  for (std::size_t k = 1; k < 3; ++k)
    if (speed_source(k) == k) set_speed(k, fill.speeds[k - 1]);
  for (const int direction : {-1, 0, 1}) {
    LaneRegime& lane = lane_regimes_[index(direction)];
    lane = lane_regime(regime(direction), contact, direction);
    lane.x = response(direction).x.data();
    lane.y = response(direction).y.data();
  }
}

/// Of equal regimes the first is tabulated.
void CoupledTable::set_response(std::size_t k, const BuildingOscillator& building,
                                TableFill& fill) {
  const RegimeOscillator& r = regimes_[k];
  const double per_w = r.contact.weight * vertical_ratio_;
  source_[k] = 0;
  while (source_[k] < k && (r.contact.mass != regimes_[source_[k]].contact.mass ||
                            per_w != regimes_[source_[k]].contact.weight * vertical_ratio_))
    ++source_[k];
  // The regime's own scaled state is x / mass, y / sqrt(mass).
  const double root = std::sqrt(r.contact.mass);
  const OscillatorStep s = oscillator_step(r.angle / root, building.damping_ratio / root);
  ResponseFill& f = fill.responses[k];
  f.step = {s.xx,
            s.xy * root,
            s.xy / root,
            s.yy,
            s.x_start,
            s.x_end,
            s.y_start / root,
            s.y_end / root,
            r.contact.mass * sign_,
            per_w};
  if (source_[k] != k) return;
  Response& response = responses_[k];
  const std::size_t tiles = tiles_of(fill.nodes);
  f.x = response.x.room(tiles * tile);
  f.y = response.y.room(tiles * tile);
  f.lag = r.lag;
  f.per_step = r.per_angle;
  f.c_x = r.alpha_radps / r.beta_radps;
  f.c_y = r.omega_radps / r.beta_radps;
  f.per_mass = r.per_mass;
  f.amplitude = response.amplitude.room(tiles);
  f.resisting = response.a_mps2.room(tiles);
  f.x_size = response.x_mps2.room(tiles);
}

/// From |x| and |x + 2 zeta y| by tile to bounds between nodes.
void CoupledTable::set_bounds(Response& response, const RegimeOscillator& r) const {
  const double per_w = r.contact.weight * vertical_ratio_, step = r.angle,
               largest_a_g = nodes_->a.peak_acceleration_mps2();
  response.largest_a_mps2 = response.largest_x_mps2 = 0.0;
  for (std::size_t b = 0; b < tiles_of(nodes_->quiet + 1); ++b) {
    const double w = std::abs(per_w) *
                     std::max(-nodes_->tile_lowest_w_mps2[b], nodes_->tile_highest_w_mps2[b]),
                 a = (response.a_mps2[b] + w) / r.contact.mass +
                     0.125 * r.phase * r.phase * response.amplitude[b];
    response.a_mps2[b] = static_cast<float>(a) * room;
    response.x_mps2[b] =
        (response.x_mps2[b] + static_cast<float>(0.125 * step * step * (a + largest_a_g))) * room;
    response.largest_a_mps2 =
        std::max(response.largest_a_mps2, static_cast<double>(response.a_mps2[b]));
    response.largest_x_mps2 =
        std::max(response.largest_x_mps2, static_cast<double>(response.x_mps2[b]));
  }
}

LaneTables CoupledTable::lanes(const CoupledTable* yielding, const Yielding& spring) const {
  LaneTables t;
  t.ground = nodes_->a.nodes().data();
  t.vertical = nodes_->vertical ? nodes_->w.nodes().data() : nullptr;
  t.quiet = static_cast<std::int64_t>(nodes_->quiet);
  t.end = static_cast<std::int64_t>(std::min(nodes_->quiet, nodes_->a.last_sample()));
  t.sign = sign_;
  t.step_s = nodes_->a.step_s();
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
  const double coarse =
      (gravity_mps2_ + nodes_->lowest_w(w_factor)) * cot_slope_ - intensity * of.largest_a_mps2;
  if (coarse > 0.5 * gravity_mps2_ * cot_slope_) return coarse;  // far from it
  double least = never;
  for (std::size_t b = 0; b < nodes_->tile_lowest_w_mps2.size(); ++b)
    least = std::min(least, (gravity_mps2_ + nodes_->lowest_w(w_factor, b)) * cot_slope_ -
                                intensity * of.a_mps2[b]);
  return least;
}

void CoupledTable::set_rest() {
  const float deviation = static_cast<float>(0.125 * regimes_[0].phase * regimes_[0].phase) * room;
  rest_.largest = 0.0;
  for (std::size_t b = 0; b < tiles_of(nodes_->quiet + 1); ++b) {
    rest_.tile_below[b] -= deviation * responses_[0].amplitude[b];
    rest_.tile_above[b] += deviation * responses_[0].amplitude[b];
    rest_.largest = std::max({rest_.largest, -static_cast<double>(rest_.tile_below[b]),
                              static_cast<double>(rest_.tile_above[b])});
  }
}

void CoupledTable::set_speed(std::size_t k, const LineFill& fill) {
  const RegimeOscillator& r = regimes_[k];
  Speed& speed = speeds_[k - 1];
  speed.largest = 0.0;
  const float per_change = static_cast<float>(0.125 * r.dt_s) * room,
              phase = static_cast<float>(r.phase) * room;
  for (std::size_t b = 0; b < tiles_of(nodes_->quiet + 1); ++b) {
    speed.tile_deviation[b] =
        per_change * (speed.tile_deviation[b] + phase * responses_[source_[k]].amplitude[b]);
    speed.largest = std::max({speed.largest, -static_cast<double>(fill.tile_lowest[b]),
                              static_cast<double>(fill.tile_highest[b])});
  }
}

}  // namespace glissade::block_detail
