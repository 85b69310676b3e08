// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/two_axes/pool/rest_tables.hpp"

#include <algorithm>

#include "block/two_axes/scene.hpp"

namespace glissade::block_detail::two_axes {

BuildingKey key_of(const BiaxialBuilding& building) {
  const auto& [first, second] = building.horizontal;
  if (first.rigid()) return {};
  return {first, second, building.mass_ratio};
}

std::size_t modes_of(const TwoAxisScene& scene) {
  const auto& [first, second] = scene.building.horizontal;
  return std::max(first.size(), second.size());
}

namespace {

/// Numbers at a node.
std::size_t rows_of(const TwoAxisScene& scene, RoofKind roof) {
  if (roof == RoofKind::modes) return 2 + 2 * row_terms;
  return roof == RoofKind::coupled_modes ? 2 + 4 * modes_of(scene) : 6;
}

/// Each search for a capacity needs the tables of its batch again.
std::size_t most_kept(const GroundNodes& nodes, std::size_t rows) {
  constexpr std::size_t most_bytes = 32 << 20;
  const std::size_t bytes = rows * sizeof(double) * (nodes.quiet + 1);
  return std::clamp<std::size_t>(most_bytes / bytes, 2, 64);
}

}  // namespace

std::shared_ptr<const RestTable> RestTables::of(const TwoAxisScene& scene, const GroundNodes& nodes,
                                                RoofKind roof) {
  const BuildingKey key = key_of(scene.building);
  for (const auto& [other, table] : kept_)
    if (key == other) return table;
  std::shared_ptr<RestTable> table;
  const bool of_modes = roof == RoofKind::modes;
  while (kept_.size() >= most_kept(nodes, rows_of(scene, roof))) {
    auto& [other, oldest] = kept_.front();
    if (oldest.use_count() == 1 && of_modes == !oldest->rows.empty()) table = std::move(oldest);
    kept_.erase(kept_.begin());
  }
  if (table == nullptr) table = std::make_shared<RestTable>();
  if (of_modes)
    table->tabulate(nodes, scene.building.horizontal);
  else
    table->tabulate(nodes, constants_of(scene, 1.0), roof);
  return kept_.emplace_back(key, std::move(table)).second;
}

}  // namespace glissade::block_detail::two_axes
