// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/block/two_axis.hpp"

#include <cmath>
#include <numbers>

#include "block/full_model/body.hpp"
#include "glissade/core/contract.hpp"
#include "glissade/core/finite.hpp"

namespace glissade {
namespace {

using block_detail::BuildingAxis;
using block_detail::BuildingContact;
using block_detail::Excitation;
using block_detail::FullModelBody;
using block_detail::PathPiece;
using block_detail::TwoAxisTrack;

[[maybe_unused]] bool is_whole(std::span<const double> component, std::size_t samples) {
  return component.empty() || component.size() == samples;
}

void check(const TwoAxisAcceleration& roof, [[maybe_unused]] const TwoAxisBlock& block) {
  for (const auto& horizontal : roof.horizontal_mps2)
    require_acceleration(horizontal, "the horizontal roof acceleration");
  require_acceleration(roof.vertical_mps2, "the vertical roof acceleration");
  require_finite({roof.dt_s}, "step");
  GLISSADE_EXPECTS(roof.dt_s > 0.0 && !roof.horizontal_mps2[0].empty());
  GLISSADE_EXPECTS(is_whole(roof.horizontal_mps2[1], roof.horizontal_mps2[0].size()) &&
                   is_whole(roof.vertical_mps2, roof.horizontal_mps2[0].size()));
  GLISSADE_EXPECTS(block.law.is_coulomb());
}

TwoAxisResult slide_with(const TwoAxisAcceleration& roof, const TwoAxisBlock& block,
                         double tolerance, std::vector<PathPiece>* path) {
  check(roof, block);
  require_tolerance(tolerance, 1e-11);
  const BuildingContact contact(block);
  const BuildingAxis rigid({}, {}, 0.0, roof.dt_s);
  TwoAxisTrack track(contact.loading().to_plan(), {}, {});
  track.keep(path);
  FullModelBody body(contact, {rigid, rigid}, 0.0, 1, roof.dt_s, tolerance, track);
  body.follow(Excitation(roof), 0.0);
  return body.result();
}

}  // namespace

double srss_of_maxima_m(const TwoAxisResult& result) {
  return std::hypot(result.peak_by_axis.along_m, result.peak_by_axis.across_m);
}

TwoAxisResult slide_two_axis(const TwoAxisAcceleration& roof, const TwoAxisBlock& block,
                             double tolerance) {
  return slide_with(roof, block, tolerance, nullptr);
}

TwoAxisResult slide_two_axis(const TwoAxisAcceleration& roof, const TwoAxisBlock& block,
                             std::vector<TwoAxisPoint>& history, double tolerance) {
  std::vector<PathPiece> path;
  const TwoAxisResult result = slide_with(roof, block, tolerance, &path);
  history.assign(1, TwoAxisPoint{});
  const auto add = [&](double time_s, block_detail::Vector d) {
    history.push_back({time_s, {d.s, d.y}});
  };
  for (const PathPiece& piece : path) {
    if (piece.begin_s > history.back().time_s) add(piece.begin_s, piece.points.front());
    add(piece.end_s, piece.points.back());
  }
  return result;
}

}  // namespace glissade
