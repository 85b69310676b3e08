// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace glissade::test {

/// The recurrence for an oscillator under piecewise-linear ground acceleration with the
/// coefficients as a textbook prints them (Chopra, Dynamics of Structures, table 5.2.1), unit mass,
/// load p = -a:
///   u1 = A u0 + B v0 + C p0 + D p1,   v1 = A1 u0 + B1 v0 + C1 p0 + D1 p1
/// They cancel badly for small omega dt: use them with many digits.
template <class Real>
struct TextbookOscillator {
  Real A, B, C, D, A1, B1, C1, D1;

  TextbookOscillator(const Real& omega, const Real& damping, const Real& dt) {
    using std::cos, std::exp, std::sin, std::sqrt;
    const Real k = omega * omega, root = sqrt(1 - damping * damping), wd = omega * root;
    const Real e = exp(-damping * omega * dt), s = sin(wd * dt), c = cos(wd * dt);
    const Real lag = 2 * damping / (omega * dt);
    A = e * (damping / root * s + c);
    B = e * s / wd;
    C = (lag +
         e * (((1 - 2 * damping * damping) / (wd * dt) - damping / root) * s - (1 + lag) * c)) /
        k;
    D = (1 - lag + e * ((2 * damping * damping - 1) / (wd * dt) * s + lag * c)) / k;
    A1 = -e * omega / root * s;
    B1 = e * (c - damping / root * s);
    C1 = (-1 / dt + e * ((omega / root + damping / (dt * root)) * s + c / dt)) / k;
    D1 = (1 - e * (damping / root * s + c)) / (k * dt);
  }
};

}  // namespace glissade::test
