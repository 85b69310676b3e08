// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "cli/child.hpp"

namespace glissade::test {
namespace {

using Json = nlohmann::json;

class Fit : public testing::Test {
 protected:
  Json fit_json(std::vector<std::string> options) const {
    options.insert(options.begin(), "fit");
    options.push_back("--json");
    const Finished child = run_program(options);
    EXPECT_EQ(child.status, 0) << child.err;
    EXPECT_EQ(child.err, "");
    return Json::parse(child.out);
  }
  ScratchFolder folder_;
};

TEST_F(Fit, bakers_stripes_give_the_known_numbers) {
  // Input: Baker 2015, Earthquake Spectra 31(1):579-599. Results: recomputed with two independent
  // programs.
  const std::string counts = folder_.write(
      "counts.csv",
      "# Baker 2015\nim,num_gms,num_exceed\n0.2,40,0\n0.3,40,0\n0.4,40,0\n0.6,40,4\n0.7,40,6\n"
      "0.8,40,13\n0.9,40,12\n1.0,40,16\n");
  const Json fit = fit_json({"--counts", counts});
  EXPECT_NEAR(fit["median"], 1.076115794, 1e-6);
  EXPECT_NEAR(fit["log_std"], 0.4292372038, 1e-6);
  EXPECT_NEAR(fit["median_interval_95"][0], 0.964246, 1e-6);
  EXPECT_NEAR(fit["median_interval_95"][1], 1.306991, 1e-6);
  EXPECT_NEAR(fit["log_std_interval_95"][0], 0.301758, 1e-6);
  EXPECT_NEAR(fit["log_std_interval_95"][1], 0.650025, 1e-6);
  EXPECT_TRUE(fit.at("log_likelihood").is_number_float());
  EXPECT_TRUE(fit.at("method").is_string());
  EXPECT_EQ(fit.at("converged"), true);
}

TEST_F(Fit, capacities_give_the_mean_and_deviation_of_their_logarithms) {
  // ln: -1, 0, 1, 4; mean 1, sum of squares 14, n - 1 = 3.
  std::string text = "im_cap\n";
  for (const double ln : {-1.0, 0.0, 1.0, 4.0})
    text += std::to_string(std::exp(ln)) + "\n";  // six decimals
  const Json fit = fit_json({"--capacities", folder_.write("capacities.csv", text)});
  EXPECT_NEAR(fit["median"], std::numbers::e, 1e-5);
  EXPECT_NEAR(fit["log_std"], std::sqrt(14.0 / 3.0), 1e-5);
  EXPECT_EQ(fit["converged"], true);
}

/// Statistics.md: sum of [ln phi(z) - ln beta - ln x] over the reached, and (n - m) ln[1 -
/// Phi(z_max)].
double censored_log_likelihood(const std::vector<double>& reached, double censored, double limit,
                               double median, double log_std) {
  const auto z = [&](double x) { return std::log(x / median) / log_std; };
  double sum = censored * std::log(0.5 * std::erfc(z(limit) / std::numbers::sqrt2));
  for (const double x : reached) {
    sum += -0.5 * z(x) * z(x) - 0.5 * std::log(2.0 * std::numbers::pi) - std::log(log_std * x);
  }
  return sum;
}

TEST_F(Fit, censored_capacities_maximise_the_censored_likelihood) {
  const std::string file = folder_.write("capacities.csv", "im_cap\n0.5\n0.8\n1\n1.2\n2\n2.5\n3\n");
  const Json fit =
      fit_json({"--capacities", file, "--censor-at", "2.5"});  // 2.5 and 3 were not reached by 2.5
  const double median = fit["median"], log_std = fit["log_std"];
  const auto at = [](double m, double s) {
    return censored_log_likelihood({0.5, 0.8, 1.0, 1.2, 2.0}, 2.0, 2.5, m, s);
  };
  EXPECT_NEAR(fit["log_likelihood"], at(median, log_std), 1e-9);
  for (const double factor : {0.999, 1.001}) {
    EXPECT_GT(at(median, log_std), at(factor * median, log_std));
    EXPECT_GT(at(median, log_std), at(median, factor * log_std));
  }
  const double uncensored = fit_json({"--capacities", file})["median"];
  EXPECT_GT(median, uncensored);  // taking 2.5 and 3 as they stand would bias it low here
}

TEST_F(Fit, separated_counts_are_fitted_by_the_labelled_penalty) {
  // Separated (theory.md, 6.2): x 0.2 to 1.2, k 0 0 0 20 20 20: no finite maximum; Jeffreys.
  const Json fit =
      fit_json({"--counts", folder_.write("counts.csv",
                                          "im,num_gms,num_exceed\n0.2,20,0\n0.4,20,0\n0.6,20,0\n0."
                                          "8,20,20\n1.0,20,20\n1.2,20,20\n")});
  EXPECT_NEAR(fit["median"], 0.6928211161, 1e-6);
  EXPECT_NEAR(fit["log_std"], 0.06843924275, 1e-6);
  EXPECT_THAT(std::string(fit["method"]), testing::ContainsRegex("Jeffreys|penali"));
}

TEST_F(Fit, flat_counts_have_no_curve) {
  for (const char* rows : {"0.5,20,10\n1,20,10\n2,20,10\n", "0.2,20,7\n0.4,20,7\n0.8,20,7\n"}) {
    const Json fit = fit_json(
        {"--counts", folder_.write("counts.csv", "im,num_gms,num_exceed\n" + std::string(rows))});
    EXPECT_EQ(fit["converged"], false);
    EXPECT_EQ(fit["status"], "no rise with intensity");
    EXPECT_TRUE(fit["median"].is_null());
  }
}

TEST_F(Fit, capacities_of_zero_are_the_floor) {
  const Json fit = fit_json({"--capacities", folder_.write("c.csv", "im_cap\n0\n0\n0.5\n1\n2\n")});
  EXPECT_NEAR(fit["floor"], 0.4, 1e-12);
  EXPECT_NEAR(fit["median"], 1.0, 1e-12);
  // 0.4 + 0.6 Phi(z) = 0.5 with z = Phi^-1(1/6) = -0.967421566 (tables), log_std = ln 2
  EXPECT_NEAR(fit["p50"], std::exp(-0.967421566 * std::log(2.0)), 1e-8);
  EXPECT_LT(fit["floor_interval_95"][0], 0.4);
  EXPECT_GT(fit["floor_interval_95"][1], 0.4);
  const Json all = fit_json({"--capacities", folder_.write("all.csv", "im_cap\n0\n0\n")});
  EXPECT_EQ(all["status"], "exceeds at any intensity");
  EXPECT_EQ(all["floor"], 1.0);
}

TEST_F(Fit, text_shows_the_same) {
  const Finished child =
      run_program({"fit", "--capacities", folder_.write("c.csv", "im_cap\n1\n2\n4\n")});
  EXPECT_EQ(child.status, 0);
  EXPECT_THAT(child.out,
              testing::ContainsRegex("median +2 +95 % interval"));  // the geometric mean of 1, 2, 4
}

TEST_F(Fit, neither_or_both_inputs_are_refused) {
  const std::string counts = folder_.write("n.csv", "im,num_gms,num_exceed\n0.2,40,1\n0.4,40,9\n");
  const std::string capacities = folder_.write("c.csv", "im_cap\n1\n2\n");
  expect_refused(run_program({"fit"}), {"--counts", "--capacities"});
  expect_refused(run_program({"fit", "--counts", counts, "--capacities", capacities}),
                 {"--counts", "--capacities"});
  expect_refused(run_program({"fit", "--counts", counts, "--censor-at", "2"}),
                 {"--censor-at", "--capacities"});
  expect_refused(run_program({"fit", "--capacities", capacities, "--censor-at", "0"}),
                 {"--censor-at", "> 0"});
}

TEST_F(Fit, every_bad_row_is_reported_at_once) {
  const std::string file = folder_.write("n.csv",
                                         "im,num_gms,num_exceed\n0.2,40,41\n-1,40,2\n0.4,40,x\n0.5,"
                                         "40\n0.6,40,nan\n0.7,40,3\n0.7,40,4\n");
  expect_refused(run_program({"fit", "--counts", file, "--json"}),
                 {"n.csv:2: num_exceed is larger than num_gms", "n.csv:3: im is not above 0",
                  "n.csv:4", "'x'", "n.csv:5", "n.csv:6", "nan", "n.csv:8", "line 7"});
}

TEST_F(Fit, another_header_or_no_rows_are_refused) {
  expect_refused(run_program({"fit", "--counts", folder_.write("a.csv", "im,n,k\n1,2,1\n")}),
                 {"a.csv:1", "im,num_gms,num_exceed"});
  expect_refused(run_program({"fit", "--capacities", folder_.write("b.csv", "im_cap\n")}),
                 {"b.csv", "no rows"});
  expect_refused(run_program({"fit", "--capacities", folder_.write("c.csv", "")}),
                 {"c.csv", "empty"});
  expect_refused(run_program({"fit", "--capacities", folder_.path("none.csv").string()}),
                 {"none.csv", "No such file"});
}

}  // namespace
}  // namespace glissade::test
