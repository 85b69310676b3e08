// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "cli/json_of.hpp"

namespace glissade::test {
namespace {

class Fit : public testing::Test {
 protected:
  Json fit_json(const std::vector<std::string>& options) const { return json_of({"fit"}, options); }
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

TEST_F(Fit, capacities_that_were_not_reached_need_the_level_up_to_which_they_were_not) {
  const std::string rows = "im_cap\n0.5\n0.8\n1\n1.2\n2\n";
  const std::string open = folder_.write("open.csv", rows + "inf\ninf\n");
  expect_refused(run_program({"fit", "--capacities", open}),
                 {"im_cap", "2 of 7", "--censor-at", "largest capacity in the file is 2"});
  EXPECT_EQ(fit_json({"--capacities", open, "--censor-at", "2.5"}),
            fit_json({"--capacities", folder_.write("filled.csv", rows + "2.5\n3\n"), "--censor-at",
                      "2.5"}));
}

// Each row at its own intensity: the time is linear in the rows (it was quadratic).
TEST_F(Fit, many_rows_are_announced_and_fitted) {
  std::string counts = "im,num_gms,num_exceed\n";
  constexpr int rows = 30000;
  for (int i = 1; i <= rows; ++i) {  // of a lognormal with median 1.5 and log std 0.4
    const double x = 1e-4 * i, share = 0.5 * std::erfc(-std::log(x / 1.5) / 0.4 / std::sqrt(2.0));
    const bool exceeds = i * 7919 % rows < share * rows;
    counts += std::to_string(x) + ",1," + (exceeds ? "1" : "0") + "\n";
  }
  const Finished child =
      succeeding({"fit", "--json", "--counts", folder_.write("counts.csv", counts)});
  EXPECT_THAT(child.err, testing::HasSubstr("fitting 30000 rows"));
  EXPECT_NEAR(Json::parse(child.out).at("median").get<double>(), 1.5, 0.02);
}

TEST_F(Fit, a_table_of_records_by_intensities_that_is_too_large_says_what_to_give) {
  std::string text = "im,num_gms,num_exceed,record\n";
  for (int i = 1; i <= 4000; ++i)
    text += std::to_string(i) + ",1," + std::to_string(i % 2) + ",r" + std::to_string(i) + "\n";
  expect_refused(run_program({"fit", "--counts", folder_.write("wide.csv", text)}),
                 {"4000 records at 4000 intensities", "levels"});
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

TEST_F(Fit, counts_that_end_below_one_half_say_so_and_leave_the_median_open) {
  const std::string file =
      folder_.write("low.csv", "im,num_gms,num_exceed\n0.3,40,0\n0.4,40,1\n0.5,40,2\n");
  const Json fit = fit_json({"--counts", file});
  EXPECT_EQ(fit["status"], "extrapolated beyond the data");
  EXPECT_THAT(fit["note"].get<std::string>(), testing::HasSubstr("end below 50 %"));
  EXPECT_TRUE(fit["median_interval_95"][1].is_null());
  EXPECT_THAT(run_program({"fit", "--counts", file}).out, testing::HasSubstr("unbounded"));
  EXPECT_THAT(run_program({"fit", "--counts",
                           folder_.write("none.csv", "im,num_gms,num_exceed\n0.3,40,0\n")})
                  .out,
              testing::HasSubstr("log_std (assumed)"));
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

TEST_F(Fit, one_level_has_a_status_and_no_number_that_is_none) {
  const std::string file = folder_.write("one.csv", "im,num_gms,num_exceed\n0.5,10,4\n");
  EXPECT_EQ(fit_json({"--counts", file})["status"], "one level");
  const Finished child = run_program({"fit", "--counts", file});
  EXPECT_EQ(child.status, 0);
  EXPECT_THAT(child.out, testing::Not(testing::HasSubstr("nan")));
}

TEST_F(Fit, records_give_intervals_over_records_and_a_test_of_the_lognormal) {
  std::string capacities = "record,im_cap\n", counts = "im,num_gms,num_exceed,record\n";
  for (int record = 0; record < 6; ++record) {
    const std::string name = "RSN" + std::to_string(record);
    for (const double x : {0.5, 0.8, 1.1})
      capacities += name + "," + std::to_string(x * (1.0 + 0.1 * record)) + "\n";
    for (int level = 1; level <= 3; ++level)
      counts += std::to_string(0.4 * level) + ",10," + std::to_string(2 * level + record % 3) +
                "," + name + "\n";
  }
  const Json by_record = fit_json({"--capacities", folder_.write("r.csv", capacities)});
  EXPECT_THAT(by_record["interval_method"], testing::HasSubstr("records"));
  EXPECT_GT(by_record["goodness_of_fit"]["p_value"], 0.0);
  const Json models = fit_json({"--counts", folder_.write("n.csv", counts)})["models"];
  EXPECT_EQ(models["status"], "compared");
  EXPECT_EQ(models["lognormal"]["difference"], 0.0);
  EXPECT_TRUE(models["logit"]["score"].is_number_float());
  EXPECT_FALSE(models.contains("two_part"));
}

TEST_F(Fit, weights_give_the_effective_records) {
  const Json fit = fit_json({"--capacities", folder_.write("w.csv",
                                                           "im_cap,weight\n0.5,1\n0.8,1\n1.2,2\n"
                                                           "9,0\n")});
  EXPECT_NEAR(fit["effective_records"], 16.0 / 6.0, 1e-12);
  EXPECT_NEAR(std::log(fit["median"].get<double>()),
              (std::log(0.5) + std::log(0.8) + 2 * std::log(1.2)) / 4, 1e-9);
  std::string plain = "im_cap\n", ones = "im_cap,weight,record\n";
  for (const char* c : {"0.5", "0.6", "0.8", "0.9"}) {
    plain += std::string(c) + "\n";
    ones += std::string(c) + ",2,RSN" + c + "\n";
  }
  EXPECT_EQ(fit_json({"--capacities", folder_.write("plain.csv", plain)}),
            fit_json({"--capacities", folder_.write("ones.csv", ones)}));
  expect_refused(
      run_program({"fit", "--capacities", folder_.write("z.csv", "im_cap,weight\n0.5,0\n1,0\n")}),
      {"z.csv", "weight"});
  expect_refused(run_program({"fit", "--counts",
                              folder_.write("c.csv",
                                            "im,num_gms,num_exceed,weight\n"
                                            "0.5,9,1,1\n1,9,5,1\n")}),
                 {"weight", "record"});
}

TEST_F(Fit, brackets_of_the_capacity_are_fitted) {
  const Json fit =
      fit_json({"--capacities",
                folder_.write("b.csv", "im_low,im_high\n0,0.5\n0.5,1\n0.5,1\n1,1.5\n1.5,inf\n")});
  EXPECT_EQ(fit["status"], "maximum likelihood");
  EXPECT_GT(fit["median"], 0.5);
  EXPECT_LT(fit["median"], 1.2);
  const Json none =
      fit_json({"--capacities", folder_.write("n.csv", "im_low,im_high\n1,inf\n2,inf\n")});
  EXPECT_EQ(none["status"], "lower bound");
}

TEST_F(Fit, brackets_from_zero_to_infinity_give_no_median) {
  const std::string file = folder_.write("e.csv", "im_low,im_high\n0,inf\n0,inf\n0,inf\n");
  const Json fit = fit_json({"--capacities", file});
  EXPECT_EQ(fit["status"], "no information");
  EXPECT_EQ(fit["converged"], false);
  EXPECT_TRUE(fit["median"].is_null());
  EXPECT_TRUE(fit["log_std"].is_null());
  EXPECT_THAT(fit["note"].get<std::string>(), testing::HasSubstr("3 row(s) from 0 to infinity"));
  const Finished child = run_program({"fit", "--capacities", file});
  EXPECT_EQ(child.status, 0);
  EXPECT_THAT(child.out, testing::HasSubstr("no information"));
  EXPECT_THAT(child.out, testing::Not(testing::HasSubstr("nan")));
  EXPECT_THAT(child.out, testing::Not(testing::HasSubstr("median")));
  const Json one = fit_json(
      {"--capacities", folder_.write("o.csv", "im_low,im_high\n0.5,1\n0.8,0.8\n1.5,2\n0,inf\n")});
  EXPECT_EQ(one["status"], "maximum likelihood");
  EXPECT_THAT(one["note"].get<std::string>(), testing::HasSubstr("1 row(s) from 0 to infinity"));
}

TEST_F(Fit, a_cloud_gives_the_regression_and_the_half_of_each_threshold) {
  // ln edp = 1 + 2 ln im -+ 0.3; all slip: half exceed e^1 at 1.
  std::string text = "im,edp\n";
  for (const double im : {0.5, 1.0, 2.0}) {
    for (const double e : {-0.3, 0.3})
      text += std::to_string(im) + "," + std::to_string(std::exp(1.0 + e) * im * im) + "\n";
  }
  const std::string file = folder_.write("cloud.csv", text);
  const Json fit = fit_json({"--cloud", file, "--threshold", "2.718281828459045"});
  EXPECT_EQ(fit["any_slip"]["status"], "all slip");
  EXPECT_NEAR(fit["size"]["slope"], 2.0, 1e-4);  // six decimals
  EXPECT_NEAR(fit["size"]["intercept"], 1.0, 1e-4);
  EXPECT_NEAR(fit["size"]["log_std"], std::sqrt(6 * 0.09 / 4), 1e-4);
  EXPECT_NEAR(fit["thresholds"][0]["p50"], 1.0, 1e-4);
  expect_refused(run_program({"fit", "--cloud", file}), {"--threshold"});
  EXPECT_THAT(run_program({"fit", "--cloud", file, "--threshold", "1"}).out,
              testing::Not(testing::HasSubstr("nan")));
}

TEST_F(Fit, text_shows_the_same) {
  const Finished child =
      run_program({"fit", "--capacities", folder_.write("c.csv", "im_cap\n1\n2\n4\n")});
  EXPECT_EQ(child.status, 0);
  EXPECT_THAT(
      child.out,
      testing::ContainsRegex("95 % interval\n +median +2 +0"));  // the geometric mean of 1, 2, 4
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

TEST_F(Fit, states_what_is_taken_as_independent) {
  const std::string rows = "0.4,20,1\n0.6,20,6\n0.8,20,12\n1.0,20,18\n";
  const Json plain =
      fit_json({"--counts", folder_.write("a.csv", "im,num_gms,num_exceed\n" + rows)});
  EXPECT_THAT(std::string(plain.at("note")), testing::HasSubstr("every trial is taken as indep"));
  EXPECT_THAT(std::string(plain.at("warning")), testing::HasSubstr("IDA"));
  std::string by_event = "im_cap,record,event\n";
  for (const char* row : {"0.41,a,E1", "0.43,b,E1", "0.62,c,E2", "0.65,d,E2", "0.81,e,E3"})
    by_event += std::string(row) + "\n";
  const Json event = fit_json({"--capacities", folder_.write("b.csv", by_event)});
  EXPECT_THAT(std::string(event.at("note")), testing::HasSubstr("event, of which there are 3"));
}

}  // namespace
}  // namespace glissade::test
