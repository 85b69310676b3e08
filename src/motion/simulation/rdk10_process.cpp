// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/motion/simulation/rdk10_process.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <numbers>

#include "glissade/core/contract.hpp"
#include "glissade/core/distributions.hpp"
#include "glissade/core/root.hpp"

namespace glissade {
namespace {

constexpr double shortest_shape = 1.0, longest_shape = 1e4;

double unit_quantile(double fraction, double shape) {
  return boost::math::gamma_p_inv(shape, fraction);
}

/// D5-95 over t_mid of a gamma density of this shape; decreases with the shape.
double duration_ratio(double shape) {
  return (unit_quantile(0.95, shape) - unit_quantile(0.05, shape)) / unit_quantile(0.45, shape);
}

double shape_of_ratio(double ratio) {
  if (ratio >= duration_ratio(shortest_shape)) return shortest_shape;
  GLISSADE_EXPECTS(ratio > duration_ratio(longest_shape));
  return std::exp(
      root_between([&](double log_shape) { return duration_ratio(std::exp(log_shape)) - ratio; },
                   std::log(shortest_shape), std::log(longest_shape), 45));
}

}  // namespace

Rdk10Envelope::Rdk10Envelope(const Rdk10Parameters& parameters)
    : shape_(shape_of_ratio(parameters.significant_duration_s / parameters.middle_time_s)),
      scale_s_(parameters.middle_time_s / unit_quantile(0.45, shape_)),
      a1_(std::sqrt(parameters.arias_g2s *
                    std::exp(-shape_ * std::log(scale_s_) - log_gamma(shape_)))) {}

double Rdk10Envelope::operator()(double time_s) const {
  return a1_ * std::pow(time_s, a2() - 1.0) * std::exp(-a3() * time_s);
}

double Rdk10Envelope::arias_time_s(double fraction) const {
  return scale_s_ * unit_quantile(fraction, shape_);
}

std::vector<double> rdk10_process_g(const Rdk10Parameters& parameters, double dt_s,
                                    std::span<const double> noise) {
  GLISSADE_EXPECTS(dt_s > 0.0 && parameters.damping_ratio > 0.0 && parameters.damping_ratio < 1.0);
  const Rdk10Envelope envelope(parameters);
  const double first_s = envelope.arias_time_s(0.01), last_s = envelope.arias_time_s(0.99);
  const double zeta = parameters.damping_ratio, damped = std::sqrt(1.0 - zeta * zeta);
  const auto frequency_radps = [&](double time_s) {
    const double since_middle_s = std::clamp(time_s, first_s, last_s) - parameters.middle_time_s;
    return 2.0 * std::numbers::pi *
           std::max(0.3, parameters.middle_frequency_hz +
                             parameters.frequency_slope_hzps * since_middle_s);
  };

  // h(t - tau, tau) = w / sqrt(1 - z^2) exp(-z w (t - tau)) sin(w sqrt(1 - z^2) (t - tau)), w of
  // the time tau of the impulse, by its recurrence h_n+1 = 2 d cos(.) h_n - d^2 h_n-1 with d =
  // exp(-z w dt): eight impulses side by side.
  constexpr Eigen::Index lanes = 8;
  using Lanes = Eigen::Array<double, lanes, 1>;
  const auto samples = static_cast<Eigen::Index>(noise.size());
  Eigen::Array<double, lanes, Eigen::Dynamic> response(lanes, samples), variance(lanes, samples);
  response.setZero();
  variance.setZero();
  for (Eigen::Index start = 0; start < samples; start += lanes) {
    Lanes impulse = Lanes::Zero(), turn = Lanes::Zero(), decay = Lanes::Zero(),
          first_value = Lanes::Zero();
    double slowest_decay = 1e300;
    for (Eigen::Index lane = 0; lane < std::min(lanes, samples - start); ++lane) {
      const double w = frequency_radps(static_cast<double>(start + lane) * dt_s),
                   d = std::exp(-zeta * w * dt_s);
      impulse[lane] = noise[static_cast<std::size_t>(start + lane)];
      turn[lane] = 2.0 * d * std::cos(w * damped * dt_s);
      decay[lane] = d * d;
      first_value[lane] = w / damped * d * std::sin(w * damped * dt_s);
      slowest_decay = std::min(slowest_decay, zeta * w * dt_s);
    }
    const auto length = lanes + static_cast<Eigen::Index>(std::ceil(11.5 / slowest_decay));
    const Eigen::Index end = std::min(samples, start + length);
    Lanes now = Lanes::Zero(), before = Lanes::Zero();
    for (Eigen::Index i = start; i < end; ++i) {
      // h is zero at the impulse; from this value before it the recurrence gives the first value
      // after it.
      if (const Eigen::Index lane = i - start; lane < lanes && decay[lane] > 0.0)
        before[lane] = -first_value[lane] / decay[lane];
      response.col(i) += impulse * now;
      variance.col(i) += now * now;
      const Lanes next = turn * now - decay * before;
      before = now;
      now = next;
    }
  }

  std::vector<double> acceleration_g(noise.size(), 0.0);
  for (Eigen::Index i = 1; i < samples; ++i)
    acceleration_g[static_cast<std::size_t>(i)] = envelope(static_cast<double>(i) * dt_s) *
                                                  response.col(i).sum() /
                                                  std::sqrt(variance.col(i).sum());
  return acceleration_g;
}

void high_pass(std::span<double> acceleration, double dt_s, double corner_hz) {
  // s^2 / (s + w)^2: two equal first-order sections in series.
  const double c = std::numbers::pi * corner_hz * dt_s;
  for (int section = 0; section < 2; ++section) {
    double input_before = 0.0, output = 0.0;
    for (double& a : acceleration) {
      output = ((1.0 - c) * output + a - input_before) / (1.0 + c);
      input_before = a;
      a = output;
    }
  }
}

}  // namespace glissade
