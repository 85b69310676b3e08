// SPDX-License-Identifier: GPL-3.0-or-later
// Simulated spectra against BSSA14 (and BSSA14 times the V/H of Gulerce & Abrahamson): four
// scenarios, 200 simulations each. Writes simulated_spectra.csv, .md and two figures into the
// folder that is given. Ends with 1 if a median or a dispersion is off by more than the tolerance
// (the vertical's dispersion, too, is compared with BSSA14's sigma).

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>

#include "glissade/core/units.hpp"
#include "glissade/motion/simulation/bssa14.hpp"
#include "glissade/motion/simulation/gain_calibration.hpp"

namespace {

using namespace glissade;

constexpr std::size_t simulations = 200;
constexpr std::uint64_t seed = 20260101;
constexpr double median_tolerance = 0.10, log_std_tolerance = 0.12;
constexpr double first_judged_s = 0.03, last_judged_s = 2.0;
constexpr std::array periods_s = {0.01, 0.02, 0.03, 0.04, 0.05, 0.075, 0.1, 0.15, 0.2,
                                  0.3,  0.4,  0.5,  0.75, 1.0,  1.5,   2.0, 3.0,  4.0};
constexpr std::array<Scenario, 4> scenarios = {{{7.0, 20.0, 760.0, FaultMechanism::strike_slip},
                                                {7.0, 20.0, 400.0, FaultMechanism::strike_slip},
                                                {6.0, 5.0, 400.0, FaultMechanism::strike_slip},
                                                {7.5, 10.0, 400.0, FaultMechanism::strike_slip}}};

enum class Direction { horizontal, vertical };

struct Moments {
  std::array<double, periods_s.size()> log_mean{}, log_std{};
};

/// Mean and standard deviation of ln Sa over the ensemble, Sa in m/s2.
Moments spectral_moments(const std::vector<RawMotion>& motions, Direction direction) {
  std::vector<std::vector<double>> spectra;
  for (const RawMotion& motion : motions)
    spectra.push_back(direction == Direction::horizontal
                          ? horizontal_rotd50_mps2(motion, periods_s)
                          : vertical_spectrum_mps2(motion, periods_s));
  Moments moments;
  const auto count = static_cast<double>(spectra.size());
  for (std::size_t p = 0; p < periods_s.size(); ++p) {
    double sum = 0.0, squares = 0.0;
    for (const auto& spectrum : spectra) sum += std::log(spectrum[p]);
    const double mean = sum / count;
    for (const auto& spectrum : spectra) squares += std::pow(std::log(spectrum[p]) - mean, 2);
    moments.log_mean[p] = mean;
    moments.log_std[p] = std::sqrt(squares / (count - 1.0));
  }
  return moments;
}

struct Row {
  double period_s, simulated_g, target_g, fresh_ratio, log_std, sigma;
  double ratio() const { return simulated_g / target_g; }
  double log_std_difference() const { return log_std - sigma; }
  bool good() const {
    return std::abs(ratio() - 1.0) <= median_tolerance &&
           std::abs(log_std_difference()) <= log_std_tolerance;
  }
  bool judged() const { return period_s >= first_judged_s && period_s <= last_judged_s; }
};

struct Panel {
  std::string name;
  Direction direction;
  std::vector<Row> rows;
};

std::vector<EnsembleMember> simulate(const Scenario& scenario, std::uint64_t first_realization) {
  std::vector<EnsembleMember> ensemble;
  for (std::uint64_t k = 0; k < simulations; ++k)
    ensemble.push_back(
        {scenario, simulate_raw_motion(scenario, {seed, first_realization + k}, 0.005)});
  return ensemble;
}

std::vector<RawMotion> shape_all(const std::vector<EnsembleMember>& ensemble,
                                 const SuiteGain& gain) {
  std::vector<RawMotion> motions;
  for (const EnsembleMember& member : ensemble) motions.push_back(shape_motion(member.raw, gain));
  return motions;
}

/// The gain comes from one set of simulations; the fresh ratio is the median of another under the
/// same gain.
std::vector<Panel> verify(const Scenario& scenario) {
  const auto ensemble = simulate(scenario, 0);
  const SuiteGain gain = calibrate_gain(ensemble);
  const auto motions = shape_all(ensemble, gain),
             fresh = shape_all(simulate(scenario, simulations), gain);
  std::vector<Panel> panels;
  for (const Direction direction : {Direction::horizontal, Direction::vertical}) {
    const Moments simulated = spectral_moments(motions, direction),
                  again = spectral_moments(fresh, direction);
    const auto target = direction == Direction::horizontal
                            ? target_horizontal_mps2(scenario, periods_s)
                            : target_vertical_mps2(scenario, periods_s);
    Panel panel{
        fmt::format("M{} R{} V{}", scenario.magnitude, scenario.distance_km, scenario.vs30_mps),
        direction,
        {}};
    for (std::size_t p = 0; p < periods_s.size(); ++p)
      panel.rows.push_back({periods_s[p], std::exp(simulated.log_mean[p]) / standard_gravity_mps2,
                            target[p] / standard_gravity_mps2,
                            std::exp(again.log_mean[p]) / target[p], simulated.log_std[p],
                            bssa14_dispersion(scenario, periods_s[p]).total()});
    panels.push_back(std::move(panel));
  }
  return panels;
}

std::string_view name(Direction direction) {
  return direction == Direction::horizontal ? "horizontal" : "vertical";
}

std::string verdict(const Row& row) {
  return !row.judged() ? "not judged" : row.good() ? "pass" : "FAIL";
}

void write_csv(std::ostream& out, const std::vector<Panel>& panels) {
  out << "scenario,component,period_s,simulated_median_g,target_median_g,ratio,fresh_ratio,"
         "simulated_log_std,"
         "bssa14_sigma,difference,verdict\n";
  for (const Panel& panel : panels)
    for (const Row& r : panel.rows)
      out << fmt::format("{},{},{},{:.5f},{:.5f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{}\n",
                         panel.name, name(panel.direction), r.period_s, r.simulated_g, r.target_g,
                         r.ratio(), r.fresh_ratio, r.log_std, r.sigma, r.log_std_difference(),
                         verdict(r));
}

void write_markdown(std::ostream& out, const std::vector<Panel>& panels) {
  out << "| scenario | component | median / target, 0.03-2 s | fresh 200, same gain | at 0.01 s | "
         "ln-sd - sigma, 0.03-2 s | verdict |\n"
         "|-|-|-|-|-|-|-|\n";
  for (const Panel& panel : panels) {
    const auto range = [&](const std::function<double(const Row&)>& value) {
      double low = 1e300, high = -1e300;
      for (const Row& row : panel.rows)
        if (row.judged()) low = std::min(low, value(row)), high = std::max(high, value(row));
      return std::pair{low, high};
    };
    const auto [low, high] = range(&Row::ratio);
    const auto [fresh_low, fresh_high] = range(&Row::fresh_ratio);
    const auto [narrow, wide] = range(&Row::log_std_difference);
    const bool good = std::all_of(panel.rows.begin(), panel.rows.end(),
                                  [](const Row& r) { return !r.judged() || r.good(); });
    out << fmt::format(
        "| {} | {} | {:.3f} to {:.3f} | {:.2f} to {:.2f} | {:.2f} | {:+.3f} to {:+.3f} | {} |\n",
        panel.name, name(panel.direction), low, high, fresh_low, fresh_high,
        panel.rows.front().ratio(), narrow, wide, good ? "pass" : "FAIL");
  }
}

/// Four panels: the simulated median and its band of one standard deviation over the target's.
void draw(const std::filesystem::path& folder, const std::vector<Panel>& panels,
          Direction direction) {
  const std::string stem = fmt::format("simulated_spectra_{}", name(direction));
  std::ofstream script(folder / (stem + ".gp"));
  script << "set terminal svg size 900,760 font 'Helvetica,15' background '#ffffff'\n"
         << "set output '" << stem << ".svg'\n"
         << "set multiplot layout 2,2 margins 0.09,0.985,0.085,0.955 spacing 0.1,0.135\n"
            "set logscale xy\nset xrange [0.02:4]\nset yrange [0.003:5]\nset format y '%g'\n"
            "set xtics (0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 4)\nset ytics (0.01, 0.03, 0.1, "
            "0.3, 1, 3)\n"
            "set grid lc rgb '#dddddd' lt 1 lw 0.7\nset xlabel 'period (s)' offset 0,0.4\nset "
            "ylabel 'Sa, 5 % damped (g)' offset 1\n"
            "set key bottom left Left reverse samplen 2 font ',13' width -3\n";
  const std::string target = direction == Direction::horizontal ? "BSSA14" : "BSSA14 x V/H";
  int block = 0;
  for (const Panel& panel : panels) {
    if (panel.direction != direction) continue;
    const std::string data = fmt::format("$data{}", ++block);
    script << data << " << EOD\n";
    for (const Row& r : panel.rows)
      script << fmt::format("{} {} {} {} {}\n", r.period_s, r.simulated_g, r.log_std, r.target_g,
                            r.sigma);
    script << "EOD\nset title '" << panel.name << "' offset 0,-0.7\nplot " << data
           << " using 1:($2*exp(-$3)):($2*exp($3)) with filledcurves lc rgb '#bcd7ee' title "
              "'simulated, one log-std', "
           << data << " using 1:2 with lines lw 2.5 lc rgb '#1f5a96' title 'simulated, median', "
           << data << " using 1:4 with lines lw 2 dt 2 lc rgb '#b3361b' title '" << target
           << ", median', " << data
           << " using 1:($4*exp(-$5)) with lines lw 1.2 dt 3 lc rgb '#b3361b' title '" << target
           << ", one sigma', " << data
           << " using 1:($4*exp($5)) with lines lw 1.2 dt 3 lc rgb '#b3361b' notitle\nunset key\n";
  }
  script << "unset multiplot\n";
  script.close();
  const auto command = fmt::format("cd '{}' && gnuplot {}.gp", folder.string(), stem);
  if (std::system(command.c_str()) != 0) std::cerr << "gnuplot failed: " << command << '\n';
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: verify_simulation FOLDER\n";
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder);
  std::vector<Panel> panels;
  for (const Scenario& scenario : scenarios)
    for (Panel& panel : verify(scenario)) panels.push_back(std::move(panel));
  std::ofstream csv(folder / "simulated_spectra.csv"), markdown(folder / "simulated_spectra.md");
  write_csv(csv, panels);
  write_markdown(markdown, panels);
  draw(folder, panels, Direction::horizontal);
  draw(folder, panels, Direction::vertical);
  bool good = true;
  for (const Panel& panel : panels)
    for (const Row& row : panel.rows) good = good && (!row.judged() || row.good());
  std::cout << (good ? "all within tolerance\n" : "outside tolerance: see simulated_spectra.csv\n");
  return good ? 0 : 1;
}
