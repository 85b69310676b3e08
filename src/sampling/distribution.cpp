// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/sampling/distribution.hpp"

#include <algorithm>
#include <boost/math/distributions/triangular.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <numeric>

#include "glissade/core/contract.hpp"
#include "glissade/core/finite.hpp"
#include "glissade/core/normal.hpp"

namespace glissade {
namespace {

/// Phi^-1 of a probability below; the probability above is given too: the smaller is exact.
struct Share {
  double below, above;
};
double standard_quantile(Share share) {
  return share.below < share.above ? normal_quantile(share.below) : -normal_quantile(share.above);
}

boost::math::triangular boost_triangular(const Triangular& d) { return {d.min, d.mode, d.max}; }

std::vector<double> sorted(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values;
}

/// Values in increasing order, each with its probability.
struct Atom {
  double value, share;
};
std::vector<Atom> atoms(const Discrete& d) {
  const double total = std::accumulate(d.weights.begin(), d.weights.end(), 0.0);
  std::vector<Atom> result;
  for (std::size_t i = 0; i < d.values.size(); ++i)
    result.push_back({d.values[i], d.weights[i] / total});
  std::stable_sort(result.begin(), result.end(), [](Atom a, Atom b) { return a.value < b.value; });
  return result;
}

struct Quantile {
  double u;

  double operator()(const Fixed& d) const { return d.value; }
  double operator()(const Normal& d) const {
    return d.mean + d.std * standard_quantile({u, 1 - u});
  }
  double operator()(const TruncatedNormal& d) const {
    // Probabilities of the parent below and above the value: sums of positive terms, so exact in
    // both tails.
    const double a = (d.min - d.mean) / d.std, b = (d.max - d.mean) / d.std;
    const double below_min = normal_cdf(a), above_max = normal_cdf(-b);
    const double inside = a > 0 ? normal_cdf(-a) - above_max : normal_cdf(b) - below_min;
    const double z = standard_quantile({below_min + u * inside, above_max + (1 - u) * inside});
    return std::clamp(d.mean + d.std * z, d.min, d.max);
  }
  double operator()(const LogNormal& d) const {
    return d.median * std::exp(d.log_std * standard_quantile({u, 1 - u}));
  }
  double operator()(const Uniform& d) const { return std::lerp(d.min, d.max, u); }
  double operator()(const Triangular& d) const { return quantile(boost_triangular(d), u); }
  double operator()(const Discrete& d) const {
    const std::vector<Atom> all = atoms(d);
    double below = 0;
    for (const Atom& atom : all) {
      below += atom.share;
      if (u < below) return atom.value;
    }
    return all.back().value;
  }
  double operator()(const Empirical& d) const {
    if (!std::is_sorted(d.values.begin(), d.values.end()))
      return (*this)(Empirical{sorted(d.values)});
    const double position = u * static_cast<double>(d.values.size() - 1);
    const auto i = std::min(static_cast<std::size_t>(position), d.values.size() - 2);
    return std::lerp(d.values[i], d.values[i + 1], position - static_cast<double>(i));
  }
};

struct MeanAndVariance {
  double mean, variance;
};

/// By quadrature of the density relative to its peak: no difference of nearly equal terms for any
/// range. Truncated where the density is exp(-40) of its peak.
MeanAndVariance truncated_moments(double a, double b) {
  const double peak = std::clamp(0.0, a, b);
  const double reach = std::sqrt(peak * peak + 80);
  const double low = std::max(a, -reach), high = std::min(b, reach);
  const auto integral = [&](auto&& f) {
    const auto weighted = [&](double t) { return f(t) * std::exp(-0.5 * t * (t + 2 * peak)); };
    return boost::math::quadrature::gauss_kronrod<double, 31>::integrate(weighted, low - peak,
                                                                         high - peak, 10, 1e-13);
  };
  const double total = integral([](double) { return 1.0; });
  const double center = integral([](double t) { return t; }) / total;
  const double variance = integral([&](double t) { return (t - center) * (t - center); }) / total;
  return {peak + center, variance};
}

struct MomentsOf {
  MeanAndVariance operator()(const Fixed& d) const { return {d.value, 0}; }
  MeanAndVariance operator()(const Normal& d) const { return {d.mean, d.std * d.std}; }
  MeanAndVariance operator()(const TruncatedNormal& d) const {
    const MeanAndVariance z = truncated_moments((d.min - d.mean) / d.std, (d.max - d.mean) / d.std);
    return {d.mean + d.std * z.mean, d.std * d.std * z.variance};
  }
  MeanAndVariance operator()(const LogNormal& d) const {
    const double mean = d.median * std::exp(0.5 * d.log_std * d.log_std);
    return {mean, mean * mean * std::expm1(d.log_std * d.log_std)};
  }
  MeanAndVariance operator()(const Uniform& d) const {
    return {std::midpoint(d.min, d.max), (d.max - d.min) * (d.max - d.min) / 12};
  }
  MeanAndVariance operator()(const Triangular& d) const {
    return {boost::math::mean(boost_triangular(d)), boost::math::variance(boost_triangular(d))};
  }
  MeanAndVariance operator()(const Discrete& d) const {
    MeanAndVariance m{0, 0};
    for (const Atom& atom : atoms(d)) m.mean += atom.share * atom.value;
    for (const Atom& atom : atoms(d))
      m.variance += atom.share * (atom.value - m.mean) * (atom.value - m.mean);
    return m;
  }
  /// Uniform pieces of equal probability between neighbouring order statistics.
  MeanAndVariance operator()(const Empirical& d) const {
    const std::vector<double> x = sorted(d.values);
    const double share = 1.0 / static_cast<double>(x.size() - 1);
    MeanAndVariance m{0, 0};
    for (std::size_t i = 1; i < x.size(); ++i) m.mean += share * std::midpoint(x[i - 1], x[i]);
    for (std::size_t i = 1; i < x.size(); ++i) {
      const MeanAndVariance piece = (*this)(Uniform{x[i - 1], x[i]});
      m.variance += share * (piece.variance + (piece.mean - m.mean) * (piece.mean - m.mean));
    }
    return m;
  }
};

Support extremes(const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return {*low, *high};
}

struct SupportOf {
  Support operator()(const Fixed& d) const { return {d.value, d.value}; }
  Support operator()(const Normal&) const { return {-infinity, infinity}; }
  Support operator()(const TruncatedNormal& d) const { return {d.min, d.max}; }
  Support operator()(const LogNormal&) const { return {0, infinity}; }
  Support operator()(const Uniform& d) const { return {d.min, d.max}; }
  Support operator()(const Triangular& d) const { return {d.min, d.max}; }
  Support operator()(const Discrete& d) const { return extremes(d.values); }
  Support operator()(const Empirical& d) const { return extremes(d.values); }
};

}  // namespace

double quantile(const Distribution& distribution, double u) {
  GLISSADE_EXPECTS(u > 0 && u < 1);
  return std::visit(Quantile{u}, distribution);
}

double mean(const Distribution& distribution) { return std::visit(MomentsOf{}, distribution).mean; }

double standard_deviation(const Distribution& distribution) {
  return std::sqrt(std::visit(MomentsOf{}, distribution).variance);
}

Support support(const Distribution& distribution) { return std::visit(SupportOf{}, distribution); }

}  // namespace glissade
