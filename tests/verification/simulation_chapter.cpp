// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <sstream>

#include "chapters.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/file.hpp"
#include "glissade/io/suite_file.hpp"
#include "glissade/motion/simulation/bssa14.hpp"
#include "glissade/motion/simulation/gulerce_abrahamson.hpp"
#include "glissade/motion/simulation/rdk10_process.hpp"
#include "glissade/motion/simulation/suite_design.hpp"
#include "glissade/motion/suite_scaling.hpp"
#include "page.hpp"

namespace glissade::verification {
namespace {

void add_parameters(std::vector<Case>& cases) {
  const Rdk10Scores nu = rdk10_mean_scores({7.0, 20.0, 760.0});
  const Rdk10Parameters p = rdk10_parameters(nu);
  const Rdk10Envelope q(p);
  // Tolerances: half a digit of the last one of the number, and a tenth.
  cases = compare_all("RDK10, strike-slip, M 7, R 20 km, V 760 m/s",
                      "test vector with the coefficients of SCEC BBP rzz2015_gmpe.py",
                      {{"score of J", {nu[0], .9470, 5.5e-5, Metric::absolute}},
                       {"score of D5-95", {nu[1], .2422, 5.5e-5, Metric::absolute}},
                       {"score of t_mid", {nu[2], -.2821, 5.5e-5, Metric::absolute}},
                       {"score of f_mid", {nu[3], .2864, 5.5e-5, Metric::absolute}},
                       {"score of f'", {nu[4], -.1111, 5.5e-5, Metric::absolute}},
                       {"score of zeta", {nu[5], .7360, 5.5e-5, Metric::absolute}},
                       {"J, g2 s", {p.arias_g2s, .03113, 5.5e-6, Metric::absolute}},
                       {"D5-95, s", {p.significant_duration_s, 18.710, 5.5e-4, Metric::absolute}},
                       {"t_mid, s", {p.middle_time_s, 9.2369, 5.5e-5, Metric::absolute}},
                       {"f_mid, Hz", {p.middle_frequency_hz, 6.2327, 5.5e-5, Metric::absolute}},
                       {"f', Hz/s", {p.frequency_slope_hzps, -.06674, 5.5e-6, Metric::absolute}},
                       {"zeta", {p.damping_ratio, .30681, 5.5e-6, Metric::absolute}},
                       {"envelope a1", {q.a1(), .0134502, 5.5e-8, Metric::absolute}},
                       {"envelope a2", {q.a2(), 2.23158, 5.5e-6, Metric::absolute}},
                       {"envelope a3", {q.a3(), .158105, 5.5e-7, Metric::absolute}}});
}

void add_medians(std::vector<Case>& cases) {
  const Scenario scenario{7.0, 20.0, 400.0};
  const std::string name = "BSSA14 median, M 7, R 20 km, V 400 m/s",
                    source = "OpenQuake's test table";
  cases.push_back(
      compare({name, "PGV, m/s", source}, {bssa14_median_pgv_mps(scenario), 0.206835, 1e-4}));
  for (const auto& [period_s, sa_g] : {std::pair{0.0, 0.200024},
                                       {0.1, 0.338914},
                                       {0.2, 0.454207},
                                       {0.5, 0.332947},
                                       {1.0, 0.183794},
                                       {2.0, 0.0806607}})
    cases.push_back(compare({name, fmt::format("Sa({} s), g", period_s), source},
                            {bssa14_median_sa_g(scenario, period_s), sa_g, 1e-4}));
  for (const auto& [period_s, ratio] : {std::pair{0.0, 0.6859},
                                        {0.05, 0.9751},
                                        {0.1, 0.8007},
                                        {0.2, 0.5508},
                                        {0.5, 0.3899},
                                        {1.0, 0.4161},
                                        {2.0, 0.4589}})
    cases.push_back(compare(
        {"Gulerce & Abrahamson 2011, M 7, R 20 km, V 400 m/s", fmt::format("V/H({} s)", period_s),
         "pygmm, four digits"},
        {vertical_to_horizontal_ratio(scenario, period_s), ratio, 1.1e-4, Metric::absolute}));
}

// -- the spectra of many simulations, as verify_simulation left them

void add_simulated_spectra(std::vector<Case>& cases, const std::filesystem::path& file) {
  enum Column { scenario, component, period, ratio = 5, log_std_difference = 9, columns = 11 };
  struct Worst {
    double ratio = 0.0, log_std = 0.0;
  };
  std::vector<std::pair<std::string, Worst>> panels;
  std::istringstream in(read_text_file(file));
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line)) {
    const auto cells = csv_cells(line);
    if (cells.size() != columns)
      throw InputError(
          {file.string(), "a row has not 11 cells: " + line, "run verify_simulation again", ""});
    const std::string name = cells[scenario] + ", " + cells[component];
    if (panels.empty() || panels.back().first != name) panels.push_back({name, {}});
    const double period_s = std::stod(cells[period]);
    if (period_s < 0.03 || period_s > 2.0) continue;
    Worst& worst = panels.back().second;
    worst.ratio = worse(worst.ratio, std::abs(std::stod(cells[ratio]) - 1.0));
    worst.log_std = worse(worst.log_std, std::abs(std::stod(cells[log_std_difference])));
  }
  for (const auto& [name, worst] : panels) {
    const bool vertical = name.ends_with("vertical");
    const std::string simulations = "200 simulations, " + name;
    cases.push_back(limit(
        {simulations, "median Sa, 0.03 to 2 s", vertical ? "BSSA14 times V/H" : "BSSA14, RotD50"},
        {"largest relative difference", worst.ratio, 0.10}));
    if (vertical) continue;  // BSSA14 has no dispersion for it
    cases.push_back(limit({simulations, "dispersion of ln Sa, 0.03 to 2 s", "BSSA14's sigma"},
                          {"largest difference", worst.log_std, 0.12}));
  }
}

// -- the suites that are shipped

struct AtRest {
  double velocity = 0.0, displacement = 0.0;
};

/// Final velocity and displacement of a component over their peaks; exact integration of the
/// piecewise-linear record.
AtRest final_motion(double dt_s, std::span<const double> a) {
  double v = 0.0, u = 0.0, peak_v = 0.0, peak_u = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double next = i + 1 < a.size() ? a[i + 1] : 0.0;
    u += v * dt_s + (2.0 * a[i] + next) * dt_s * dt_s / 6.0;
    v += 0.5 * (a[i] + next) * dt_s;
    peak_v = std::max(peak_v, std::abs(v));
    peak_u = std::max(peak_u, std::abs(u));
  }
  return {std::abs(v) / peak_v, std::abs(u) / peak_u};
}

void add_suite(std::vector<Case>& cases, const std::filesystem::path& suites, int level) {
  const SyntheticRecipe recipe = read_recipe(suites / fmt::format("synthetic_level{}.toml", level));
  const Suite suite = simulate_suite(recipe);
  const WaltersLevel& limits = walters_level(level);
  const std::string name = fmt::format("suite level {}", level);
  int outside = 0;
  double largest_scale = 0.0;
  AtRest worst;
  for (std::size_t i = 0; i < suite.motions.size(); ++i) {
    const Motion& m = suite.motions[i];
    outside += m.magnitude < limits.min_magnitude || m.magnitude > limits.max_magnitude ||
                       m.distance_km < limits.min_distance_km ||
                       m.distance_km > limits.max_distance_km || m.vs30_mps < limits.min_vs30_mps ||
                       m.vs30_mps > limits.max_vs30_mps
                   ? 1
                   : 0;
    largest_scale = std::max(largest_scale, m.scale);
    for (const auto* a : {&m.horizontal_mps2[0], &m.horizontal_mps2[1], &m.vertical_mps2}) {
      const AtRest end = final_motion(m.dt_s, *a);
      worst.velocity = worse(worst.velocity, end.velocity);
      worst.displacement = worse(worst.displacement, end.displacement);
    }
  }
  const TargetSpectrum target(recipe.target);
  std::vector<double> many_periods_s;  // not the periods the suite was scaled at
  for (int i = 0; i <= 2000; ++i) many_periods_s.push_back((i + 0.37) / 1000.37);
  const double lift = suite_average_factor(
      suite, [&](double t) { return target.mce_sa_g(t); }, many_periods_s);
  cases.push_back(all_equal(
      {name, "magnitude, distance and Vs30 of its motions", "Walters et al. 2012, table 2"},
      {outside, static_cast<int>(suite.motions.size())}));
  cases.push_back(within({name, "largest scale factor", "Walters et al. 2012, table 2"},
                         {"factor", largest_scale, 0.0, limits.max_scale}));
  cases.push_back(within({name, "average SRSS spectrum / MCE spectrum, 2001 other periods to 2 s",
                          "Walters et al. 2012: nowhere below"},
                         {"least ratio", 1.0 / lift, 0.995, 1.001}));
  cases.push_back(limit({name, "velocity at the end, 21 components", "0"},
                        {"largest, of the component's peak", worst.velocity, 1e-3}));
  cases.push_back(limit({name, "displacement at the end, 21 components", "0"},
                        {"largest, of the component's peak", worst.displacement, 1e-2}));
}

}  // namespace

Chapter simulated_motions(const Folders& folders) {
  Chapter chapter{
      "8. Simulated motions",
      "RDK10, BSSA14; Walters et al. 2012, table 2",
      R"(The stochastic model of Rezaeian & Der Kiureghian (2010, RDK10) and the ground-motion models are compared
with the digits of their references. The table has four scenarios of 200 simulations each, with the gain
that was found with the same 200, and 200 *fresh* ones, whose medians have a standard error of 5 %. The
sigma of BSSA14 is of horizontal motions, and only these are compared with it. Last are the built-in suites
and the requirements of Walters et al. (2012).)",
      {},
      "![Simulated horizontal spectra and BSSA14](figures/simulated_spectra_horizontal.svg)\n\n"
      "![Simulated vertical spectra and BSSA14 times "
      "V/H](figures/simulated_spectra_vertical.svg)\n"};
  add_parameters(chapter.cases);
  add_medians(chapter.cases);
  add_simulated_spectra(chapter.cases, folders.simulation / "simulated_spectra.csv");
  for (int level = 0; level < 5; ++level) add_suite(chapter.cases, folders.suites, level);
  chapter.measured = read_text_file(folders.simulation / "simulated_spectra.md");
  for (const char* figure : {"simulated_spectra_horizontal.svg", "simulated_spectra_vertical.svg"})
    std::filesystem::copy_file(folders.simulation / figure, folders.figures / figure,
                               std::filesystem::copy_options::overwrite_existing);
  return chapter;
}

}  // namespace glissade::verification
