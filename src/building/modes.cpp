// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "glissade/building/mode_rules.hpp"
#include "glissade/core/contract.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/root.hpp"

namespace glissade {
namespace {

constexpr double mass_wanted = 0.95;

/// A mode shape over the height, 0 to 1: with beta^2 = alpha^2 + gamma^2 a sum of a harmonic and
/// of exponentials from either end, so that nothing large cancels.
struct Shape {
  double gamma, beta, eta, from_top, from_base;

  Shape(double gamma_n, double alpha) : gamma(gamma_n), beta(std::hypot(alpha, gamma_n)) {
    const double s = std::sin(gamma), c = std::cos(gamma), decay = std::exp(-beta);
    const double sinh = 0.5 * (1.0 - decay * decay), cosh = 0.5 * (1.0 + decay * decay);
    const double scale = gamma * gamma * c * decay + beta * beta * cosh;
    eta = (gamma * gamma * s * decay + gamma * beta * sinh) / scale;
    // (eta - gamma / beta) e^beta / 2, with the difference taken beforehand.
    from_top = 0.5 * gamma * (gamma * (s - gamma / beta * c) - beta * decay) / scale;
    from_base = 0.5 * (eta + gamma / beta);
  }
  double operator()(double x) const {
    return std::sin(gamma * x) - eta * std::cos(gamma * x) +
           from_top * std::exp(-beta * (1.0 - x)) + from_base * std::exp(-beta * x);
  }
};

/// Zero at the n-th gamma: the condition at the free end, over cosh(beta).
double free_end(double gamma, double alpha) {
  const double beta = std::hypot(alpha, gamma), ratio = alpha * alpha / (gamma * beta);
  return 2.0 / std::cosh(beta) + (2.0 + ratio * ratio) * std::cos(gamma) +
         ratio * std::sin(gamma) * std::tanh(beta);
}

double root_of_mode(std::size_t n, double alpha) {
  const double pi = std::numbers::pi, low = n == 0 ? 1e-3 : pi * static_cast<double>(n),
               high = pi * static_cast<double>(n + 1);
  return root_between([&](double gamma) { return free_end(gamma, alpha); }, low, high, 50);
}

/// Over the height, in pieces that follow the harmonic and both exponentials.
template <class Integrand>
double integral(const Shape& shape, Integrand f) {
  const auto pieces = static_cast<int>(std::ceil(shape.beta / 4.0)) + 1;
  double sum = 0.0;
  for (int i = 0; i < pieces; ++i)
    sum += boost::math::quadrature::gauss<double, 20>::integrate(
        f, static_cast<double>(i) / pieces, static_cast<double>(i + 1) / pieces);
  return sum;
}

}  // namespace

Modes::Modes(std::span<const Mode> modes) : size_(modes.size()) {
  GLISSADE_EXPECTS(!modes.empty() && modes.size() <= most_modes);
  std::ranges::copy(modes, modes_.begin());
}

double Modes::ground_share() const {
  double share = 1.0;
  for (const Mode& mode : *this) share -= mode.participation;
  return share;
}

double Modes::accelerance() const {
  double sum = 0.0;
  for (const Mode& mode : *this) sum += mode.participation * mode.participation / mode.mass_share;
  return sum;
}

std::vector<Mode> cantilever_modes(double period_s, double alpha, std::size_t count) {
  GLISSADE_EXPECTS(period_s > 0.0 && alpha >= 0.0 && alpha <= largest_alpha);
  std::vector<Mode> modes;
  double first_rate = 0.0;
  for (std::size_t n = 0; n < count; ++n) {
    const Shape shape(root_of_mode(n, alpha), alpha);
    const double rate = shape.gamma * shape.beta;  // goes with the frequency
    if (n == 0) first_rate = rate;
    const double mean = integral(shape, shape),
                 square = integral(shape, [&](double x) { return shape(x) * shape(x); });
    modes.push_back(
        {period_s * first_rate / rate, shape(1.0) * mean / square, mean * mean / square});
  }
  return modes;
}

std::vector<Mode> shear_building_modes(std::span<const double> masses,
                                       std::span<const double> stiffnesses) {
  if (masses.empty() || masses.size() != stiffnesses.size())
    throw InputError({"the building",
                      "has " + std::to_string(masses.size()) + " masses and " +
                          std::to_string(stiffnesses.size()) + " stiffnesses",
                      "give one of each for every storey, from the ground up", ""});
  const auto is_positive = [](double x) { return x > 0.0 && std::isfinite(x); };
  if (!std::ranges::all_of(masses, is_positive) || !std::ranges::all_of(stiffnesses, is_positive))
    throw InputError({"the building", "has a mass or stiffness that is not above 0",
                      "give one of each for every storey, from the ground up", ""});
  const auto floors = static_cast<Eigen::Index>(masses.size());
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(floors, floors);
  Eigen::VectorXd mass(floors);
  for (Eigen::Index i = 0; i < floors; ++i) {
    const double k = stiffnesses[static_cast<std::size_t>(i)];
    mass[i] = masses[static_cast<std::size_t>(i)];
    stiffness(i, i) += k;
    if (i == 0) continue;
    stiffness(i - 1, i - 1) += k;
    stiffness(i, i - 1) = stiffness(i - 1, i) = -k;
  }
  const Eigen::VectorXd root = mass.cwiseSqrt(), per_root = root.cwiseInverse();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(per_root.asDiagonal() * stiffness *
                                                              per_root.asDiagonal());
  std::vector<Mode> modes;
  for (Eigen::Index n = 0; n < floors; ++n) {
    const auto shape = solver.eigenvectors().col(n);  // of unit generalised mass, times root(m)
    const double excitation = shape.dot(root);
    modes.push_back({2.0 * std::numbers::pi / std::sqrt(solver.eigenvalues()[n]),
                     excitation * shape[floors - 1] * per_root[floors - 1],
                     excitation * excitation / mass.sum()});
  }
  return modes;
}

std::vector<Mode> with_first_period(std::vector<Mode> modes, double period_s) {
  const double first_s = modes.front().period_s;
  for (Mode& mode : modes) mode.period_s = period_s * (mode.period_s / first_s);
  return modes;
}

std::vector<Mode> governing_modes(std::span<const Mode> modes) {
  std::vector<Mode> ranked(modes.begin(), modes.end()), governing;
  if (ranked.empty()) return governing;
  std::ranges::stable_sort(ranked.begin() + 1, ranked.end(), std::greater{}, &Mode::mass_share);
  double mass = 0.0;
  for (const Mode& mode : ranked) {
    if (governing.size() == most_modes || mass >= mass_wanted) break;
    if (!governing.empty() && mode.period_s < shortest_governing_period_s) continue;
    governing.push_back(mode);
    mass += mode.mass_share;
  }
  std::ranges::stable_sort(governing, std::greater{}, &Mode::period_s);
  return governing;
}

double shortest_period_s(const Modes& building) {
  double shortest_s = building.period_s();
  for (const Mode& mode : building) shortest_s = std::min(shortest_s, mode.period_s);
  return shortest_s;
}

std::string unresolved_mode(double period_s, double step_s) {
  if (period_s >= 2.0 * step_s) return "";
  return fmt::format(
      "a mode of the building has a period of {:.3g} s, below twice the time step of {:g} s of a "
      "record, which does not represent it",
      period_s, step_s);
}

double mass_of(std::span<const Mode> modes) {
  double mass = 0.0;
  for (const Mode& mode : modes) mass += mode.mass_share;
  return mass;
}

std::vector<std::string> improbable_modes(std::span<const Mode> modes) {
  constexpr double least_mass = 0.9 - 1e-9, most_left = 0.25;
  std::vector<std::string> sentences;
  double participation = 0.0;
  for (const Mode& mode : modes) participation += mode.participation;
  if (mass_of(modes) < least_mass)
    sentences.push_back(
        fmt::format("the modes carry {:.0f} % of the mass: below 90 % modes are missing",
                    100 * mass_of(modes)));
  if (std::abs(participation - 1.0) > most_left)
    sentences.push_back(
        fmt::format("the participations are {:.3g} together, far from 1: modes are missing, or "
                    "they are not those at the array",
                    participation));
  return sentences;
}

}  // namespace glissade
