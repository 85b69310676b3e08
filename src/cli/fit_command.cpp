// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>

#include "commands.hpp"
#include "glissade/core/error.hpp"
#include "glissade/fragility/fit.hpp"
#include "glissade/io/fit_input.hpp"

namespace glissade::cli {
namespace {

struct FitOptions {
  std::string counts, capacities;
  std::optional<double> censor_at;
  bool json = false;
};

/// Capacities at or above the limit were not reached by it: they count as censored there. A
/// capacity of 0 is that of an array that slides freely.
CapacitySample censored(const std::vector<double>& values, const std::optional<double>& limit) {
  CapacitySample sample;
  if (limit) sample.censored_at = *limit;
  for (const double value : values) {
    if (value == 0.0) {
      sample.free += 1.0;
    } else if (value < sample.censored_at) {
      sample.capacities.push_back(value);
    } else {
      sample.censored += 1.0;
    }
  }
  return sample;
}

FitSummary fit(const FitOptions& o) {
  if (o.counts.empty() == o.capacities.empty()) {
    throw InputError(
        {"glissade fit", "needs one of --counts and --capacities", "give one file", ""});
  }
  if (o.censor_at &&
      (o.capacities.empty() || !(*o.censor_at > 0.0) || !std::isfinite(*o.censor_at))) {
    throw InputError({"--censor-at",
                      fmt::format("{:g} must be > 0 and needs --capacities", *o.censor_at), "",
                      ""});
  }
  return o.counts.empty() ? fit_capacities(censored(read_capacities(o.capacities), o.censor_at))
                          : fit_stripes(read_counts(o.counts));
}

nlohmann::ordered_json to_json(const Interval& interval) { return {interval.low, interval.high}; }

void run(const FitOptions& o) {
  const FitSummary f = fit(o);
  if (o.json) {
    const nlohmann::ordered_json json{{"median", f.curve.median},
                                      {"log_std", f.curve.log_std},
                                      {"floor", f.curve.floor},
                                      {"p50", f.curve.intensity_at(0.5)},
                                      {"median_interval_95", to_json(f.median_interval)},
                                      {"log_std_interval_95", to_json(f.log_std_interval)},
                                      {"floor_interval_95", to_json(f.floor_interval)},
                                      {"log_likelihood", f.log_likelihood},
                                      {"method", f.method},
                                      {"interval_method", f.interval_method},
                                      {"status", to_string(f.status)},
                                      {"converged", f.converged()},
                                      {"note", f.note}};
    fmt::print("{}\n", json.dump(2));
    return;
  }
  const auto show = [](const char* name, double value, const Interval& interval) {
    fmt::print("{:<17}{:.6g}   95 % interval {:.4g} to {:.4g}\n", name, value, interval.low,
               interval.high);
  };
  if (!std::isnan(f.curve.median)) {
    show("median", f.curve.median, f.median_interval);
    show("log_std", f.curve.log_std, f.log_std_interval);
  }
  if (f.curve.floor > 0.0) {
    show("floor", f.curve.floor, f.floor_interval);
    fmt::print("50 % of all at   {:.6g}\n", f.curve.intensity_at(0.5));
  }
  if (!std::isnan(f.curve.median)) {
    fmt::print("log likelihood   {:.8g}\nmethod           {}\nintervals        {}\n",
               f.log_likelihood, f.method, f.interval_method);
  }
  fmt::print("status           {}\n", to_string(f.status));
  if (!f.note.empty()) fmt::print("note             {}\n", f.note);
}

}  // namespace

void add_fit(CLI::App& program) {
  auto o = std::make_shared<FitOptions>();
  CLI::App* command =
      program.add_subcommand("fit", "Fit a lognormal fragility to counts or capacities");
  command->add_option("--counts", o->counts, "CSV with the header im,num_gms,num_exceed");
  command->add_option("--capacities", o->capacities,
                      "CSV with the header im_cap; 0: slides freely, without shaking");
  command->add_option("--censor-at", o->censor_at,
                      "highest intensity analysed: capacities at or above it are censored");
  command->add_flag("--json", o->json, "print one JSON object");
  command->callback([o] { run(*o); });
}

}  // namespace glissade::cli
