// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "chapters.hpp"
#include "glissade/fragility/fit.hpp"
#include "glissade/fragility/hazard.hpp"
#include "unit/fragility/worked_examples.hpp"

namespace glissade::verification {
namespace {

using namespace worked_examples;

const std::string two = "two independent programs", published = "published fit; " + two;

std::vector<Case> baker() {
  const FitSummary fit = fit_stripes(baker_2015(), Independent::rows),
                   penalised = fit_stripes_jeffreys(baker_2015(), Independent::rows);
  return joined({compare_all("ex1: Baker (2015), 8 stripes of 40", two,
                             {{"median", {fit.curve.median, 1.076115794, 1e-9}},
                              {"log_std", {fit.curve.log_std, 0.4292372038, 1e-9}},
                              {"median, low end of 95 % profile interval",
                               {fit.median_interval.low, 0.964246, 1e-6}},
                              {"median, high end", {fit.median_interval.high, 1.306991, 1e-6}},
                              {"log_std, low end", {fit.log_std_interval.low, 0.301758, 2e-6}},
                              {"log_std, high end", {fit.log_std_interval.high, 0.650025, 1e-6}},
                              {"log likelihood at (0.8, 0.5)",
                               {log_likelihood(baker_2015(), {0.8, 0.5}), -39.433505974789, 1e-12,
                                Metric::absolute}}}),
                 compare_all("ex1, Jeffreys penalised", two,
                             {{"median", {penalised.curve.median, 1.086048945, 1e-9}},
                              {"log_std", {penalised.curve.log_std, 0.4478973625, 1e-9}}})});
}

std::vector<Case> others() {
  const FitSummary fit = fit_stripes(mastodon(), Independent::rows),
                   probit = fit_stripes(bliss_beetles(), Independent::rows),
                   apart = fit_stripes(separated(), Independent::rows);
  double saturated = 0.0;  // log likelihood with each stripe's own share
  for (const auto& [dose, n, k, weight, record] : bliss_beetles())
    saturated += std::lgamma(n + 1) - std::lgamma(k + 1) - std::lgamma(n - k + 1) +
                 k * std::log(k / n) + (k < n ? (n - k) * std::log1p(-k / n) : 0.0);
  const std::string separated_name = "separated: nothing to 0.6, all from 0.8, 20 each";
  return joined(
      {compare_all("ex4: MASTODON, 7 stripes of 1,000", two,
                   {{"median", {fit.curve.median, 0.40021328, 2e-8}},
                    {"log_std", {fit.curve.log_std, 0.23842755, 3e-8}},
                    {"log10 likelihood at (0.4, 0.1)",
                     {log_likelihood(mastodon(), {0.4, 0.1}) / std::log(10.0), -502.18887815, 1e-8,
                      Metric::absolute}}}),
       compare_all(
           "ex5: Bliss (1935), beetles, probit in log10 dose", published,
           {{"intercept",
             {-std::log(probit.curve.median) / probit.curve.log_std, -34.93525892, 2e-9}},
            {"slope", {std::log(10.0) / probit.curve.log_std, 19.72793422, 2e-9}},
            {"deviance",
             {2.0 * (saturated - probit.log_likelihood), 10.11975811, 5e-8, Metric::absolute}}}),
       compare_all(separated_name, two,
                   {{"median, Jeffreys penalised", {apart.curve.median, 0.6928211161, 1e-9}},
                    {"log_std, Jeffreys penalised", {apart.curve.log_std, 0.06843924275, 1e-9}}}),
       {all_equal({separated_name, "labelled as penalised", "no finite maximum of the likelihood"},
                  {apart.status == FitStatus::jeffreys_penalised ? 0 : 1, 1})}});
}

/// The rate by a sum over the intervals of a curve, with P at the left end of each.
double left_sum(const std::vector<HazardPoint>& points, const FragilityCurve& fragility) {
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    sum += fragility.probability(points[i].intensity) *
           (points[i].annual_rate - points[i + 1].annual_rate);
  return sum;
}

/// `parts` points of the same power laws in each interval.
std::vector<HazardPoint> refined(const HazardCurve& hazard, int parts) {
  std::vector<HazardPoint> fine;
  const std::vector<HazardPoint>& points = hazard.points();
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double ratio = points[i + 1].intensity / points[i].intensity;
    for (int k = 0; k < parts; ++k) {
      const double x = points[i].intensity * std::pow(ratio, static_cast<double>(k) / parts);
      fine.push_back({x, hazard.annual_rate(x)});
    }
  }
  fine.push_back(points.back());
  return fine;
}

std::vector<Case> rates() {
  const FragilityCurve fragility{0.5, 0.4};
  const std::string law = "power law 1e-4 x^-2.5, median 0.5, log_std 0.4",
                    baker = "ex7: Baker's hazard curve, median 0.5, log_std 0.4";
  const double of_law = annual_rate(HazardCurve::power_law(1e-4, 2.5), fragility);
  const HazardCurve hazard(baker_hazard());
  // Of step h the sum is off by c h, and by c' h^2 where two of them are extrapolated.
  const double coarse = left_sum(refined(hazard, 1000), fragility),
               fine = left_sum(refined(hazard, 2000), fragility);
  const HazardPoint& last = hazard.points().back();
  const double beyond = fragility.probability(last.intensity) * last.annual_rate,
               rate = annual_rate(hazard, fragility);
  return {
      compare({law, "annual rate", "closed form: k0 median^-k exp(k^2 log_std^2 / 2)"},
              {of_law, 1e-4 * std::pow(0.5, -2.5) * std::exp(0.5), 1e-12}),
      compare({law, "annual rate", "the worked example's digits"}, {of_law, 9.326575926e-4, 1e-9}),
      compare({baker, "sum with P at the left of each interval, by our P",
               "published; two independent programs"},
              {left_sum(baker_hazard(), fragility), 5.5684640934e-5, 1e-9}),
      compare({baker, "annual rate, integral",
               "that sum over 1,000 and 2,000 parts of each interval, extrapolated, and the rate "
               "beyond the last"},
              {rate, 2.0 * fine - coarse + beyond, 1e-7}),
      compare({baker, "probability in 50 years", "1 - exp(-50 rate), by its series"},
              {probability_in(50.0, rate),
               50.0 * rate * (1.0 - 25.0 * rate * (1.0 - 50.0 / 3.0 * rate * (1.0 - 12.5 * rate))),
               1e-11})};
}

}  // namespace

Chapter fragility() {
  return {
      "5.1 Fragility: fits and annual rates", "published data, two independent programs",
      R"(Fits of published data against two independent programs, to the given digits; annual rates against their
closed form and sums.)",
      joined({baker(), others(), rates()})};
}

}  // namespace glissade::verification
