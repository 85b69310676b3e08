// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "commands.hpp"
#include "fit/fit_output.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/finite.hpp"
#include "glissade/io/fit_input.hpp"
#include "shared/say.hpp"

namespace glissade::cli {
namespace {

struct FitOptions {
  std::string counts, capacities, cloud;
  std::optional<double> censor_at;
  std::vector<double> thresholds;
  bool json = false;
};

/// Of counts of an IDA: the same number of trials at every level, and counts that never fall.
bool may_be_of_the_same_records(std::vector<Stripe> rows) {
  std::ranges::sort(rows, {}, &Stripe::intensity);
  return rows.size() > 2 && rows.front().trials > 1 &&
         std::ranges::adjacent_find(rows, [](const Stripe& a, const Stripe& b) {
           return a.trials != b.trials || a.exceedances > b.exceedances;
         }) == rows.end();
}

FitOutput fit_counts(const CountsInput& input) {
  if (input.has.weight && !input.has.unit())
    throw InputError({"weight", "needs the column record: whose trials are not independent",
                      "name the record of each row", ""});
  if (!input.has.unit()) {
    FitOutput output{fit_stripes(input.rows, Independent::rows)};
    output.notes.emplace_back("every trial is taken as independent, of a record of its own");
    if (may_be_of_the_same_records(input.rows))
      output.warning =
          "every level has as many trials, and the counts never fall: if the same records are at "
          "every level (IDA), the intervals are too narrow. Name the record of each row in a "
          "column record, or fit capacities";
    return output;
  }
  FitOutput output{fit_stripes(input.rows, Independent::records)};
  if (input.has.weight || input.has.event) return output;
  std::set<double> levels;
  for (const Stripe& row : input.rows) levels.insert(row.intensity);
  output.models = compare_shapes({.intensities = {levels.begin(), levels.end()},
                                  .thresholds_m = {1.0},
                                  .stripes = {input.rows}})
                      .front();
  return output;
}

/// What was not reached says something only with the level up to which it was not.
void refuse_unknown_limit(const std::vector<Bracket>& rows) {
  const auto is_open = [](const Bracket& row) { return std::isinf(row.low); };
  const auto open = std::ranges::count_if(rows, is_open);
  if (open == 0) return;
  double largest = 0.0;
  for (const Bracket& row : rows)
    if (!is_open(row)) largest = std::max(largest, row.low);
  throw InputError({"im_cap",
                    fmt::format("{} of {} capacities are inf, not reached: up to which level?",
                                open, rows.size()),
                    fmt::format("give the highest level that was analysed as --censor-at (the "
                                "largest capacity in the file is {:g})",
                                largest),
                    ""});
}

FitOutput fit_capacities_of(CapacitiesInput input, const std::optional<double>& censor_at) {
  const double limit = censor_at.value_or(infinity);
  if (input.brackets && censor_at)
    throw InputError({"--censor-at", "is for im_cap: brackets have their own limits",
                      "give im_high = inf where im_low was not exceeded", ""});
  if (!input.brackets && !censor_at) refuse_unknown_limit(input.rows);
  for (Bracket& row : input.rows)  // not reached by the limit
    if (!input.brackets && row.low >= limit) row = {limit, infinity, row.weight, row.record};
  FitOutput output{
      fit_brackets(input.rows, input.has.unit() ? Independent::records : Independent::rows)};
  const bool nested = input.has.record && input.has.event;  // the test has no rows of records
  if (!input.brackets && input.has.unit() && !input.has.weight && !nested)
    output.lognormal = lognormal_goodness_of_fit(input.rows, {});
  return output;
}

void check_options(const FitOptions& o) {
  if (o.counts.empty() + o.capacities.empty() + o.cloud.empty() != 2) {
    throw InputError(
        {"glissade fit", "needs one of --counts, --capacities and --cloud", "give one file", ""});
  }
  if (o.censor_at && o.capacities.empty())
    throw InputError({"--censor-at", "goes with --capacities",
                      "counts and clouds state what was not exceeded", ""});
  if (o.censor_at && (!(*o.censor_at > 0.0) || !std::isfinite(*o.censor_at)))
    throw InputError({"--censor-at", fmt::format("{:g} must be > 0", *o.censor_at), "", ""});
  if (o.cloud.empty() != o.thresholds.empty())
    throw InputError({"--threshold",
                      "goes with --cloud: the displacements whose fragility is asked", "give both",
                      ""});
}

/// Of many rows, which take a while.
template <class Input>
Input announced(Input input) {
  constexpr std::size_t many = 5000;
  if (input.rows.size() > many) say("glissade: fitting {} rows\n", input.rows.size());
  return input;
}

/// What is independent, and records that may be one.
template <class Input>
void add_notes(const Input& input, FitOutput& output) {
  if (input.has.event)
    output.notes.push_back(fmt::format(
        "the unit of the intervals is the event, of which there are {}: records of one event "
        "depend on each other",
        record_count(input.rows)));
  if (!input.same.empty())
    output.warning +=
        fmt::format("{}records {} have the same rows: if they are one record, it counts twice",
                    output.warning.empty() ? "" : "; ", input.same);
}

void run(const FitOptions& o) {
  check_options(o);
  const auto fitted = [&](const auto& input, const auto& fit) {
    FitOutput output = fit(input);
    add_notes(input, output);
    if (!output.warning.empty() && !o.json) say("WARNING: {}\n", output.warning);
    print(output, o.json);
  };
  if (!o.cloud.empty())
    fitted(announced(read_cloud(o.cloud)), [&](const CloudInput& input) {
      FitOutput output;
      output.cloud = fit_cloud(input.rows, o.thresholds);
      return output;
    });
  else if (!o.counts.empty())
    fitted(announced(read_counts(o.counts)), fit_counts);
  else
    fitted(announced(read_capacities(o.capacities)),
           [&](const CapacitiesInput& input) { return fit_capacities_of(input, o.censor_at); });
}

}  // namespace

void add_fit(CLI::App& program) {
  auto o = std::make_shared<FitOptions>();
  CLI::App* command =
      program.add_subcommand("fit", "Fit a fragility to counts, capacities or a cloud");
  command->footer(
      "Every file may have the columns record (rows of one record are not\n"
      "independent: intervals are over records), event (records of one event are\n"
      "not independent: intervals are over events) and weight (importance weights).");
  command->add_option("--counts", o->counts, "CSV with the header im,num_gms,num_exceed");
  command->add_option("--capacities", o->capacities,
                      "CSV with the header im_cap; 0: slides freely, without shaking; inf: "
                      "not reached by --censor-at. Or im_low,im_high: capacities between two "
                      "levels (inf: not reached)");
  command->add_option("--cloud", o->cloud,
                      "CSV with the header im,edp: displacements at any intensities; 0: no slip; "
                      "inf: collapse, beyond every displacement");
  command->add_option("--threshold", o->thresholds,
                      "displacement thresholds for --cloud, in the unit of edp");
  command->add_option("--censor-at", o->censor_at,
                      "highest intensity analysed: capacities at or above it are censored");
  command->add_flag("--json", o->json, "print one JSON object");
  command->callback([o] { run(*o); });
}

}  // namespace glissade::cli
