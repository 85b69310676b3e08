// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/convergence.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "glissade/block/peak_slip.hpp"
#include "glissade/block/rodriguez_nikl.hpp"
#include "glissade/core/bytes.hpp"
#include "glissade/core/contract.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/hash.hpp"
#include "glissade/core/units.hpp"
#include "keep_records.hpp"

namespace glissade {
namespace {

/// The component, without the zeros at its end that a suite pads it with: they are not the
/// record's, and a block without friction would drift through them.
std::span<const double> along_slope(const Motion& motion, HorizontalComponent component) {
  std::span<const double> a =
      motion.horizontal_mps2[component == HorizontalComponent::first ? 0 : 1];
  while (!a.empty() && a.back() == 0.0) a = a.first(a.size() - 1);
  return a;
}

double peak_mps2(std::span<const double> acceleration_mps2) {
  double peak = 0.0;
  for (const double a : acceleration_mps2) peak = std::max(peak, std::abs(a));
  return peak;
}

void check(const ConvergenceConfig& config, const Suite& suite) {
  ProblemList problems;
  for (const Motion& motion : suite.motions) {
    if (config.component == HorizontalComponent::second && motion.horizontal_mps2[1].empty()) {
      problems.add({config.suite_file.string(),
                    "record " + motion.id + " has no second horizontal component",
                    "use convergence.component = \"first\", or leave the record out", ""});
    } else if (along_slope(motion, config.component).empty()) {
      problems.add({config.suite_file.string(),
                    "record " + motion.id + " is zero throughout: no factor gives it a peak",
                    "leave the record out with suite.records", ""});
    }
  }
  problems.throw_if_any();
}

std::vector<ConvergenceScene> scenes_of(const ConvergenceConfig& config) {
  std::vector<ConvergenceScene> scenes;
  for (const double slope : config.slope_deg) {
    for (const double mu : config.mu) {
      for (const double ppa : config.ppa_g) scenes.push_back({slope, mu, ppa});
    }
  }
  return scenes;
}

std::string hash_of(const ConvergencePlan& plan) {
  Hasher hasher;
  hasher.text("convergence").text(plan.config.source_text);
  hasher.number(std::uint64_t{plan.suite.motions.size()});
  for (const Motion& motion : plan.suite.motions) {
    hasher.text(motion.id).number(motion.dt_s);
    hasher.numbers(along_slope(motion, plan.config.component));
  }
  return to_hex(hasher.value());
}

/// The outcome of `work`, and its seconds: the shortest of some runs, so that a pause of the
/// machine is not taken for the history's.
template <class Work>
auto timed(const Stopwatch& now, int runs, double& seconds, const Work& work) {
  seconds = std::numeric_limits<double>::infinity();
  for (int run = 1;; ++run) {
    const double start = now();
    auto outcome = work();
    seconds = std::min(seconds, now() - start);
    if (run == runs) return outcome;
  }
}

}  // namespace

std::uint64_t ConvergencePlan::histories() const {
  return suite.motions.size() * scenes.size() * config.substeps.size();
}

int timings(int substeps) { return substeps <= 16 ? 3 : 1; }

ConvergencePlan make_plan(const ConvergenceConfig& config, Suite suite) {
  GLISSADE_EXPECTS(config.substeps.size() >= 2 && config.substeps.front() >= 1);
  keep_records({config.file, config.suite_file, config.records}, suite);
  check(config, suite);
  ConvergencePlan plan{config, std::move(suite), scenes_of(config), {}};
  plan.hash = hash_of(plan);
  return plan;
}

std::string to_string(const ConvergencePlan& plan) {
  const ConvergenceConfig& c = plan.config;
  double samples = 0.0, steps = 0.0;
  for (const Motion& motion : plan.suite.motions)
    samples += static_cast<double>(along_slope(motion, c.component).size());
  for (const int p : c.substeps) steps += samples * p;
  std::string text = fmt::format("Convergence study {}\n", c.name);
  text += fmt::format("Suite      {} ({} records), {} component, rigid roof, no vertical\n",
                      plan.suite.name, plan.suite.motions.size(),
                      c.component == HorizontalComponent::first ? "first" : "second");
  text += fmt::format("Scenes     {}: slope {:g} deg; mu {:g}; peak acceleration {:g} g\n",
                      plan.scenes.size(), fmt::join(c.slope_deg, ", "), fmt::join(c.mu, ", "),
                      fmt::join(c.ppa_g, ", "));
  text += fmt::format("Substeps   P = {}\n", fmt::join(c.substeps, ", "));
  text += fmt::format(
      "Histories  {} by the published scheme ({:.3g} substeps), {} exact, in {} units\n",
      plan.histories(), steps * static_cast<double>(plan.scenes.size()),
      plan.suite.motions.size() * plan.scenes.size(), plan.suite.motions.size());
  return text + fmt::format("Plan hash  {}\n", plan.hash);
}

ConvergenceUnit execute(const ConvergencePlan& plan, std::size_t record, const Stopwatch& now) {
  GLISSADE_EXPECTS(record < plan.suite.motions.size());
  const Motion& motion = plan.suite.motions[record];
  const std::span<const double> a = along_slope(motion, plan.config.component);
  const double peak = peak_mps2(a);
  ConvergenceUnit unit;
  unit.record = record;
  HistoryTimes& times = unit.times;
  const RoofTable table =
      timed(now, timings(1), times.table_s, [&] { return RoofTable(motion.dt_s, a); });
  for (const ConvergenceScene& scene : plan.scenes) {
    const double factor = scene.ppa_g * standard_gravity_mps2 / peak;
    const RoofAcceleration roof{motion.dt_s, a, {}, factor, 0.0};
    const Block block{.friction = scene.mu, .slope_rad = scene.slope_deg * rad_per_deg};
    for (const int substeps : plan.config.substeps) {
      const SlipResult slip = timed(now, timings(substeps), times.published_s.emplace_back(),
                                    [&] { return slide_rodriguez_nikl(roof, block, substeps); });
      unit.residual_m.push_back(slip.residual_displacement_m);
    }
    const SlipResult exact =
        timed(now, timings(1), times.exact_s.emplace_back(), [&] { return slide(roof, block); });
    unit.exact.push_back({exact.residual_displacement_m, exact.peak_displacement_m,
                          static_cast<std::uint8_t>(exact.uplift ? 1 : 0)});
    timed(now, timings(1), times.kernel_s.emplace_back(), [&] {
      return peak_slip(table, block, {factor, 0.0});
    });
  }
  return unit;
}

ConvergenceResults reduce(const ConvergencePlan& plan, const std::vector<ConvergenceUnit>& units) {
  const ConvergenceConfig& c = plan.config;
  const std::size_t records = plan.suite.motions.size(), scenes = plan.scenes.size();
  ConvergenceResults results{.study_name = c.name,
                             .study_description = c.description,
                             .program_version = GLISSADE_VERSION,
                             .plan_hash = plan.hash,
                             .study_text = c.source_text,
                             .suite_name = plan.suite.name,
                             .suite_description = plan.suite.description,
                             .component = c.component,
                             .substeps = c.substeps,
                             .scenes = plan.scenes,
                             .records = {},
                             .residual_m = {records, scenes, c.substeps.size()},
                             .exact = std::vector<ExactSlip>(records * scenes)};
  for (const Motion& motion : plan.suite.motions) {
    const std::span<const double> a = along_slope(motion, c.component);
    results.records.push_back({motion.id, motion.event, motion.station, motion.dt_s, a.size(),
                               peak_mps2(a) / standard_gravity_mps2});
  }
  std::vector<bool> there(records, false);
  for (const ConvergenceUnit& unit : units) {
    GLISSADE_EXPECTS(unit.record < records && !there[unit.record]);
    there[unit.record] = true;
    const auto row = static_cast<std::ptrdiff_t>(unit.record);
    std::copy(unit.residual_m.begin(), unit.residual_m.end(),
              results.residual_m.data.begin() +
                  row * static_cast<std::ptrdiff_t>(scenes * c.substeps.size()));
    std::copy(unit.exact.begin(), unit.exact.end(),
              results.exact.begin() + row * static_cast<std::ptrdiff_t>(scenes));
  }
  GLISSADE_EXPECTS(std::find(there.begin(), there.end(), false) == there.end());
  return results;
}

std::vector<char> pack(const std::vector<ConvergenceUnit>& units) {
  ByteWriter out;
  out.put(units.size());
  for (const ConvergenceUnit& unit : units) {
    out.put(unit.record).put(unit.residual_m).put(unit.exact);
    out.put(unit.times.published_s).put(unit.times.exact_s).put(unit.times.kernel_s);
    out.put(unit.times.table_s);
  }
  return out.take();
}

std::vector<ConvergenceUnit> unpack_convergence_units(const std::vector<char>& bytes) {
  ByteReader in(bytes);
  std::size_t count = 0;
  in.get(count);
  std::vector<ConvergenceUnit> units(count);
  for (ConvergenceUnit& unit : units) {
    in.get(unit.record).get(unit.residual_m).get(unit.exact);
    in.get(unit.times.published_s).get(unit.times.exact_s).get(unit.times.kernel_s);
    in.get(unit.times.table_s);
  }
  return units;
}

}  // namespace glissade
