// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/block/coupled_slip.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "block/contact/scaled_block.hpp"
#include "block/coupled_tables/coupled_history.hpp"
#include "block/events/coupled_walk.hpp"
#include "glissade/core/contract.hpp"

namespace glissade {

using block_detail::CoupledContact;
using block_detail::CoupledHistory;
using block_detail::CoupledNodes;
using block_detail::CoupledTable;
using block_detail::Subdivision;

namespace {

/// All that a table depends on but the motion.
struct Shared {
  double period_s, damping_ratio, mass_ratio, slope_rad, friction, static_over_sliding,
      gravity_mps2, sign, vertical_ratio;

  Shared(const CoupledScene& s, const Oscillator& oscillator, bool vertical)
      : period_s(oscillator.period_s),
        damping_ratio(oscillator.damping_ratio),
        mass_ratio(s.building.mass_ratio),
        slope_rad(std::abs(s.block.slope_rad)),
        friction(s.block.friction),
        static_over_sliding(s.block.law.static_over_sliding),
        gravity_mps2(s.block.gravity_mps2),
        sign((s.block.slope_rad < 0.0) == (s.factors.horizontal < 0.0) ? 1.0 : -1.0),
        vertical_ratio(vertical ? s.factors.vertical / std::abs(s.factors.horizontal) : 0.0) {}
  bool operator==(const Shared&) const = default;
};

/// Of gravity. With a larger vertical acceleration downward the block may lift, and the limits of
/// its rest, which are proportional to g + w, lose their digits.
constexpr double most_vertical = 0.99;

/// A period that its vibration shows between samples, and underdamped in every regime.
bool can_be_tabulated(const Subdivision& subdivision, const CoupledContact& contact, double dt_s) {
  constexpr double least_phase = 1e-3, most_damping = 0.95;
  if (subdivision.building.rigid()) return false;
  for (const double mass :
       {contact.stuck().mass, contact.sliding_down().mass, contact.sliding_up().mass}) {
    const double root = std::sqrt(mass), phase = subdivision.building.omega_radps / root * dt_s;
    if (!(phase >= least_phase && phase <= block_detail::RegimeOscillator::most_phase &&
          subdivision.building.damping_ratio / root <= most_damping))
      return false;
  }
  return true;
}

CoupledPeak by_reference(const GroundMotion& ground, const CoupledScene& scene,
                         std::span<const double> thresholds_m, std::span<Crossing> crossings) {
  return {block_detail::in_metres(
              block_detail::walk_coupled(
                  ground, scene.factors, scene.building, scene.block,
                  {block_detail::CoupledBody::Keeps::peaks, thresholds_m, crossings})
                  .slip,
              1.0),
          true};
}

}  // namespace

struct CoupledGround::Tables {
  /// The last table.
  struct Last {
    std::optional<Shared> shared;  ///< what it is of
    std::optional<CoupledTable> table;

    const CoupledTable& of(const CoupledNodes& motion, const Shared& wanted,
                           const CoupledContact& contact, const Subdivision& subdivision) {
      if (!(shared == wanted)) {
        table.emplace(motion, contact, subdivision.building, wanted.sign, wanted.vertical_ratio);
        shared = wanted;
      }
      return *table;
    }
  };
  std::shared_ptr<const CoupledNodes> nodes;
  Last elastic, yielding;
};

namespace {

/// The building while its spring yields is an elastic one of the lower stiffness (theory.md, 2.3).
Oscillator while_yielding(const CoupledBuilding& building) {
  const double root = std::sqrt(building.yielding.hardening_ratio);
  return {building.horizontal.period_s / root, building.horizontal.damping_ratio / root};
}

}  // namespace

CoupledGround::CoupledGround(const GroundMotion& motion)
    : motion_(motion),
      tables_(std::make_unique<Tables>(Tables{std::make_shared<CoupledNodes>(motion), {}, {}})) {}
CoupledGround::CoupledGround(const CoupledGround& other)
    : motion_(other.motion_),
      tables_(std::make_unique<Tables>(Tables{other.tables_->nodes, {}, {}})) {}
CoupledGround::~CoupledGround() = default;

namespace {

bool can_be_tabulated(const CoupledScene& scene, const CoupledContact& contact,
                      const CoupledNodes& nodes) {
  const bool law_fits = scene.block.law.is_coulomb() ||
                        (contact.stops_at_rest() && !scene.block.law.depends_on_speed());
  return scene.block.directions == SlipDirections::both && law_fits &&
         scene.factors.horizontal != 0.0 && (contact.slides_at_rest() || contact.stops_at_rest()) &&
         contact.up().a > 0.0 &&
         -nodes.lowest_w(scene.factors.vertical) < most_vertical * scene.block.gravity_mps2;
}

/// Of the building while its spring yields; none if it has no such table.
const CoupledTable* yielding_table(CoupledGround& ground, const CoupledScene& scene,
                                   const CoupledContact& contact) {
  const Yielding& spring = scene.building.yielding;
  if (!spring.yields() || spring.hardening_ratio == 0.0) return nullptr;
  const Oscillator oscillator = while_yielding(scene.building);
  const GroundMotion& motion = ground.motion();
  const Subdivision subdivision = block_detail::subdivide(oscillator, contact, motion.dt_s);
  if (!can_be_tabulated(subdivision, contact, motion.dt_s)) return nullptr;
  CoupledGround::Tables& tables = ground.tables();
  return &tables.yielding.of(*tables.nodes,
                             Shared(scene, oscillator, !motion.vertical_mps2.empty()), contact,
                             subdivision);
}

CoupledPeak solve(CoupledGround& ground, const CoupledScene& scene,
                  std::span<const double> thresholds_m, std::span<Crossing> crossings) {
  block_detail::require_finite_scene(scene.building, scene.block, scene.factors);
  GLISSADE_EXPECTS(coupling_is_regular(scene.block, scene.building.mass_ratio));
  const GroundMotion& motion = ground.motion();
  const CoupledContact contact(scene.block, scene.building.mass_ratio);
  const Oscillator& oscillator = scene.building.horizontal;
  const Subdivision subdivision = block_detail::subdivide(oscillator, contact, motion.dt_s);
  CoupledGround::Tables& tables = ground.tables();
  if (can_be_tabulated(subdivision, contact, motion.dt_s) &&
      can_be_tabulated(scene, contact, *tables.nodes)) {
    const Shared shared(scene, oscillator, !motion.vertical_mps2.empty());
    const CoupledTable& table = tables.elastic.of(*tables.nodes, shared, contact, subdivision);
    CoupledHistory history(table, yielding_table(ground, scene, contact), contact, subdivision,
                           scene, std::abs(scene.factors.horizontal), thresholds_m, crossings);
    if (history.run()) return {block_detail::in_metres(history.result(), 1.0), false};
  }
  return by_reference(motion, scene, thresholds_m, crossings);
}

}  // namespace

void coupled_slip(CoupledGround& ground, std::span<const CoupledScene> scenes,
                  std::span<CoupledPeak> peaks, std::span<const double> thresholds_m,
                  std::span<Crossing> crossings) {
  GLISSADE_EXPECTS(scenes.size() == peaks.size());
  GLISSADE_EXPECTS(crossings.size() == scenes.size() * thresholds_m.size());
  for (std::size_t k = 0; k < scenes.size(); ++k)
    peaks[k] = solve(ground, scenes[k], thresholds_m,
                     crossings.subspan(k * thresholds_m.size(), thresholds_m.size()));
}

void coupled_slip(const GroundMotion& ground, std::span<const CoupledScene> scenes,
                  std::span<CoupledPeak> peaks, std::span<const double> thresholds_m,
                  std::span<Crossing> crossings) {
  CoupledGround shared(ground);
  coupled_slip(shared, scenes, peaks, thresholds_m, crossings);
}

}  // namespace glissade
