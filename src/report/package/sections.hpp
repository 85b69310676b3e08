// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace glissade {

/// Of the calculation package, in their order.
enum class Section {
  scope,
  criteria,
  building,
  array,
  friction,
  motions,
  result,
  separations,
  sensitivity,
  probability,
  plausibility,
  check,
  provisions,
  checks,
  references,
  inputs
};
/// As it is printed, from 1.
constexpr int number_of(Section section) { return static_cast<int>(section) + 1; }

}  // namespace glissade
