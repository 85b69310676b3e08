// SPDX-License-Identifier: GPL-3.0-or-later
#include "plot/contour_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "glissade/core/contract.hpp"

namespace glissade {
namespace {

using Edge = std::pair<std::size_t, std::size_t>;  // of two nodes, the lower first
using Links = std::map<Edge, std::vector<Edge>>;   // the crossed edges next to a crossed edge
using Triangle = std::array<std::size_t, 3>;       // nodes, increasing

void link_if_crossed(const Triangle& nodes, const GridValues& grid, double value, Links& links) {
  const auto z = [&](std::size_t node) { return grid.z[node]; };
  if (!std::isfinite(z(nodes[0]) + z(nodes[1]) + z(nodes[2]))) return;
  std::vector<Edge> crossed;
  for (const Edge& edge :
       {Edge{nodes[0], nodes[1]}, Edge{nodes[0], nodes[2]}, Edge{nodes[1], nodes[2]}}) {
    if ((z(edge.first) >= value) != (z(edge.second) >= value)) crossed.push_back(edge);
  }
  if (crossed.empty()) return;  // else two: who leaves a side comes back
  links[crossed[0]].push_back(crossed[1]);
  links[crossed[1]].push_back(crossed[0]);
}

constexpr std::size_t parts = 4;  // of a cell's side

std::vector<double> refined(const std::vector<double>& axis) {
  std::vector<double> fine;
  for (std::size_t i = 0; i + 1 < axis.size(); ++i) {
    for (std::size_t k = 0; k < parts; ++k)
      fine.push_back(std::lerp(axis[i], axis[i + 1], static_cast<double>(k) / parts));
  }
  fine.push_back(axis.back());
  return fine;
}

/// At an end whatever the other is; from a finite value to infinity by their inverses.
double between(double low, double high, double share) {
  if (share == 0.0) return low;
  if (share == 1.0) return high;
  if (std::isinf(low) || std::isinf(high)) return 1.0 / ((1.0 - share) / low + share / high);
  return low + share * (high - low);
}

/// The same surface with parts x parts as many cells.
GridValues refined(const GridValues& grid) {
  GridValues fine{refined(grid.x), refined(grid.y), {}};
  const std::size_t width = grid.x.size();
  for (std::size_t j = 0; j < fine.y.size(); ++j) {
    for (std::size_t i = 0; i < fine.x.size(); ++i) {
      const std::size_t column = std::min(i / parts, width - 2);
      const std::size_t row = std::min(j / parts, grid.y.size() - 2);
      const double x = static_cast<double>(i - parts * column) / parts;
      const double y = static_cast<double>(j - parts * row) / parts;
      const double* corner = &grid.z[row * width + column];
      fine.z.push_back(between(between(corner[0], corner[1], x),
                               between(corner[width], corner[width + 1], x), y));
    }
  }
  return fine;
}

/// Of the triangles with three finite corners.
Links crossed_edges(const GridValues& grid, double value) {
  Links links;
  const std::size_t width = grid.x.size();
  for (std::size_t j = 0; j + 1 < grid.y.size(); ++j) {
    for (std::size_t i = 0; i + 1 < width; ++i) {
      const std::size_t least = j * width + i, largest = least + width + 1;
      link_if_crossed({least, least + 1, largest}, grid, value, links);
      link_if_crossed({least, least + width, largest}, grid, value, links);
    }
  }
  return links;
}

PlanePoint crossing(const GridValues& grid, const Edge& edge, double value) {
  const auto [a, b] = edge;
  const std::size_t width = grid.x.size();
  const double share = (value - grid.z[a]) / (grid.z[b] - grid.z[a]);
  return {std::lerp(grid.x[a % width], grid.x[b % width], share),
          std::lerp(grid.y[a / width], grid.y[b / width], share)};
}

/// The line from an edge on, taken out of the links.
Polyline take_line(Links& links, const Edge& first, const GridValues& grid, double value) {
  Polyline line;
  for (Edge edge = first;;) {
    line.push_back(crossing(grid, edge, value));
    const std::vector<Edge> next = std::move(links.extract(edge).mapped());
    const auto left =
        std::find_if(next.begin(), next.end(), [&](const Edge& e) { return links.count(e) > 0; });
    if (left != next.end()) {
      edge = *left;
      continue;
    }
    const bool closed = line.size() > 2 && std::count(next.begin(), next.end(), first) > 0;
    if (closed) line.push_back(line.front());
    return line;
  }
}

}  // namespace

std::vector<Polyline> contour_lines(const GridValues& coarse, double value) {
  GLISSADE_EXPECTS(coarse.x.size() >= 2 && coarse.y.size() >= 2);
  GLISSADE_EXPECTS(coarse.z.size() == coarse.x.size() * coarse.y.size());
  const GridValues grid = refined(coarse);
  Links links = crossed_edges(grid, value);
  std::vector<Edge> ends;
  for (const auto& [edge, next] : links) {
    if (next.size() == 1) ends.push_back(edge);
  }
  std::vector<Polyline> lines;
  for (const Edge& end : ends) {
    if (links.count(end) > 0) lines.push_back(take_line(links, end, grid, value));
  }
  while (!links.empty()) lines.push_back(take_line(links, links.begin()->first, grid, value));
  return lines;
}

}  // namespace glissade
