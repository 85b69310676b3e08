// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "commands.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/file.hpp"
#include "glissade/core/units.hpp"
#include "glissade/io/csv.hpp"
#include "glissade/io/recipe_writer.hpp"
#include "glissade/io/suite_file.hpp"
#include "glissade/motion/intensity.hpp"
#include "glissade/motion/simulation/suite_design.hpp"
#include "glissade/motion/suite_scaling.hpp"
#include "glissade/motion/walters_level.hpp"

namespace glissade::cli {
namespace {

struct SuiteOptions {
  std::string suite, out;
  std::string target = "mce";
  double damping = 0.05, max_factor = 4.0;
  int level = 2;
  std::uint64_t seed = 20260101;
};

/// To the file named by --out, else to standard output.
void deliver(const SuiteOptions& o, const std::string& text) {
  if (o.out.empty()) {
    fmt::print("{}", text);
  } else {
    write_text_file(o.out, text);
  }
}

double in_g(double acceleration_mps2) { return acceleration_mps2 / standard_gravity_mps2; }

const DesignTarget& target_of(const Suite& suite, const std::string& file) {
  if (!suite.target)
    throw InputError({file, "names no design target",
                      "add [target] with edition, ss_g, s1_g and site_classes", ""});
  return *suite.target;
}

void show(const SuiteOptions& o) {
  const Suite suite = load_suite(o.suite);
  fmt::print("{}: {}\n", suite.name, suite.description);
  if (suite.target) {
    const TargetSpectrum target(*suite.target);
    const auto level = intensity_level({suite.target->ss_g, suite.target->s1_g});
    fmt::print(
        "target: {} S_s {:g} g, S_1 {:g} g: S_DS {:.3f} g, S_D1 {:.3f} g; Intensity Level {}\n",
        to_string(suite.target->edition), suite.target->ss_g, suite.target->s1_g, target.sds_g(),
        target.sd1_g(), level ? std::to_string(*level) : "above 4");
  }
  std::size_t id_width = 2, event_width = 5, station_width = 7;
  for (const Motion& m : suite.motions) {
    id_width = std::max(id_width, m.id.size());
    event_width = std::max(event_width, m.event.size());
    station_width = std::max(station_width, m.station.size());
  }
  fmt::print("{:<{}}  {:<{}}  {:<{}} {:>4} {:>6} {:>5} {:>7} {:>7} {:>6} {:>6} {:>6} {:>6} {:>5}\n",
             "id", id_width, "event", event_width, "station", station_width, "M", "R km", "Vs30",
             "dt s", "samples", "H1 g", "H2 g", "V g", "PGV", "scale");
  const auto pga = [](const std::vector<double>& a) {
    return a.empty() ? std::string("-")
                     : fmt::format("{:.3f}", in_g(peak_ground_acceleration_mps2(a)));
  };
  for (const Motion& m : suite.motions) {
    fmt::print(
        "{:<{}}  {:<{}}  {:<{}} {:>4.1f} {:>6.1f} {:>5.0f} {:>7.4f} {:>7} {:>6} {:>6} {:>6} "
        "{:>6.3f} {:>5.2f}\n",
        m.id, id_width, m.event, event_width, m.station, station_width, m.magnitude, m.distance_km,
        m.vs30_mps, m.dt_s, m.horizontal_mps2[0].size(), pga(m.horizontal_mps2[0]),
        pga(m.horizontal_mps2[1]), pga(m.vertical_mps2),
        horizontal_pgv_mps(m, HorizontalCombination::geometric_mean), m.scale);
  }
  fmt::print(
      "PGV: m/s, geometric mean of the horizontals. Nothing here has the suite's scale applied.\n");
}

void spectra(const SuiteOptions& o) {
  const Suite suite = load_suite(o.suite);
  std::vector<double> periods{0.0};
  for (int i = 0; i < 100; ++i) periods.push_back(0.02 * std::pow(200.0, i / 99.0));
  std::vector<std::string> header{"period_s"};
  std::vector<std::vector<double>> columns;
  std::vector<double> average(periods.size(), 0.0);
  for (const Motion& m : suite.motions) {
    for (const auto combination :
         {HorizontalCombination::geometric_mean, HorizontalCombination::srss}) {
      const bool srss = combination == HorizontalCombination::srss;
      std::vector<double> sa = horizontal_spectrum_mps2(m, periods, combination, o.damping);
      for (std::size_t i = 0; i < sa.size(); ++i) {
        sa[i] = in_g(m.scale * sa[i]);
        if (srss) average[i] += sa[i] / static_cast<double>(suite.motions.size());
      }
      header.push_back(m.id + (srss ? "_srss_g" : "_geometric_mean_g"));
      columns.push_back(std::move(sa));
    }
  }
  header.push_back("average_srss_g");
  columns.push_back(average);
  if (suite.target) {
    const TargetSpectrum target(*suite.target);
    header.push_back("target_mce_g");
    columns.emplace_back();
    for (const double period : periods) columns.back().push_back(target.mce_sa_g(period));
  }
  CsvTable table(header);
  for (std::size_t i = 0; i < periods.size(); ++i) {
    table.cell(periods[i]);
    for (const auto& column : columns) table.cell(column[i]);
    table.end_row();
  }
  deliver(o,
          fmt::format(
              "# pseudo-spectral acceleration, damping {:g}, the suite's scale factors applied\n",
              o.damping) +
              table.text());
}

void scale(const SuiteOptions& o) {
  if (o.target != "mce" && o.target != "dbe")
    throw InputError({"--target", o.target + " is not a target", "give mce or dbe", ""});
  const Suite suite = load_suite(o.suite);
  const TargetSpectrum target(target_of(suite, o.suite));
  const auto wanted = [&](double period) {
    return o.target == "mce" ? target.mce_sa_g(period) : target.design_sa_g(period);
  };
  const SuiteScaling scaling =
      scale_suite_to_target(suite, wanted, walters_periods_s(), o.max_factor);
  fmt::print(
      "# one factor per record for its three components: average SRSS spectrum nowhere below the "
      "{} target from 0 to 2 s\n",
      o.target);
  fmt::print("# (Walters et al. 2012); touches it at {:g} s; largest factor {:.3f}\n",
             scaling.controlling_period_s, scaling.largest_factor);
  fmt::print("id,scale\n");
  for (std::size_t i = 0; i < suite.motions.size(); ++i)
    fmt::print("{},{:.4f}\n", suite.motions[i].id, scaling.factors[i]);
}

void design(const SuiteOptions& o) {
  const std::string origin =
      fmt::format("glissade suite design --level {} --seed {}", o.level, o.seed);
  deliver(o, recipe_toml(design_suite(o.level, o.seed), origin));
}

}  // namespace

void add_suite(CLI::App& program) {
  auto o = std::make_shared<SuiteOptions>();
  CLI::App* command =
      program.add_subcommand("suite", "Look at, scale, design or select a ground-motion suite");
  command->require_subcommand(1);
  const auto verb = [&](const char* name, const char* what, auto act) {
    CLI::App* sub = command->add_subcommand(name, what);
    sub->callback([o, act] { act(*o); });
    return sub;
  };
  const auto takes_suite = [&](CLI::App* sub) {
    sub->add_option("suite", o->suite, "suite file (TOML); see suites/")->required();
  };
  takes_suite(verb("show", "List the motions", show));
  CLI::App* spectra_verb = verb("spectra", "Response spectra as CSV", spectra);
  takes_suite(spectra_verb);
  spectra_verb->add_option("--damping", o->damping, "damping ratio")->check(CLI::Range(0.0, 0.99));
  spectra_verb->add_option("--out", o->out, "file [standard output]");
  CLI::App* scale_verb =
      verb("scale", "Scale factors to the suite's target spectrum, by Walters's rule", scale);
  takes_suite(scale_verb);
  scale_verb->add_option("--target", o->target, "mce or dbe (2/3 of it)");
  scale_verb->add_option("--max-factor", o->max_factor, "largest factor allowed");
  CLI::App* design_verb = verb(
      "design", "Design a built-in suite: recipe of seven simulated motions for an Intensity Level",
      design);
  design_verb->add_option("--level", o->level, "Walters's Seismic Intensity Level, 0 to 4")
      ->required();
  design_verb->add_option("--seed", o->seed, "seed of the simulation");
  design_verb->add_option("--out", o->out, "file [standard output]");
  add_suite_select(*command);
}

}  // namespace glissade::cli
