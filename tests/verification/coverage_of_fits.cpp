// SPDX-License-Identifier: GPL-3.0-or-later
#include "coverage_of_fits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "coverage_share.hpp"
#include "glissade/core/finite.hpp"
#include "glissade/core/normal.hpp"
#include "glissade/core/random.hpp"
#include "glissade/fragility/fit.hpp"
#include "glissade/fragility/share.hpp"
#include "glissade/study/analysis/exceeded_displacement.hpp"

namespace glissade::verification {
namespace {

// Capacities of median 1: ln C = 0.4 (sqrt(c) a + sqrt(1 - c) e), a by record and e by row.
constexpr double true_log_std = 0.4;
/// Of each row; more by GLISSADE_COVERAGE_SETS, for a smaller standard error.
int sets() {
  const char* more = std::getenv("GLISSADE_COVERAGE_SETS");
  return more == nullptr ? 1000 : std::max(1, std::atoi(more));
}

/// How the data are made, and what is kept of the capacities.
struct Design {
  const char* name;
  int rows;  ///< of a record
  double correlation;
  enum { complete, censored, counts, weighted } kind;
  double limit;         ///< highest intensity, in medians
  bool wide = false;    ///< may cover more than 97 %
  int levels = 5;       ///< of counts, equally spaced up to the limit
  bool uneven = false;  ///< records of 1, 2, 3, 5, 8, 15 and 30 rows
  double low = 0.93;    ///< that must be covered
};

constexpr std::array uneven_rows = {1, 2, 3, 5, 8, 15, 30};

constexpr std::array designs = {
    Design{"one row a record", 1, 0.0, Design::complete, infinity},
    Design{"two rows a record, correlation 0.5", 2, 0.5, Design::complete, infinity},
    Design{"10 rows a record, correlation 0", 10, 0.0, Design::complete, infinity},
    Design{"10 rows a record, correlation 0.05", 10, 0.05, Design::complete, infinity},
    Design{"10 rows a record, correlation 0.2", 10, 0.2, Design::complete, infinity},
    Design{"10 rows a record, correlation 0.5", 10, 0.5, Design::complete, infinity, false, 5,
           false, 0.89},
    Design{"1 to 30 rows a record, correlation 0.5", 30, 0.5, Design::complete, infinity, true, 5,
           true, 0.89},
    Design{"one row a record, censored at 0.8 of the median", 1, 0.0, Design::censored, 0.8},
    Design{"10 rows a record, correlation 0.05, censored at 0.8 of the median", 10, 0.05,
           Design::censored, 0.8, true},
    Design{"50 rows a record, correlation 0.75, censored at 0.8 of the median", 50, 0.75,
           Design::censored, 0.8, true},
    Design{"counts up to half the median, 10 rows a record, correlation 0", 10, 0.0, Design::counts,
           0.5, true},
    Design{"counts up to half the median, 50 rows a record, correlation 0.75", 50, 0.75,
           Design::counts, 0.5, true},
    Design{"counts at 8 levels up to twice the median, one row a record", 1, 0.0, Design::counts,
           2.0, false, 8},
    Design{"one row a record, censored at 0.6 of the median", 1, 0.0, Design::censored, 0.6, true},
    Design{"importance weights, one row a record", 1, 0.0, Design::weighted, infinity, true},
    Design{"importance weights by record, 10 rows each, correlation 0.2", 10, 0.2, Design::weighted,
           infinity, false, 5, false, 0.91},
};

/// Of importance sampling the records are drawn from capacities of which the records' part is lower
/// by half its deviation.
constexpr double shift = 0.5;

struct Data {
  std::vector<Bracket> capacities;
  std::vector<Stripe> counts;  ///< fitted where there are any
};

Data data_of(const Design& design, std::size_t records, std::uint64_t seed) {
  Data data;
  const double by_record = design.rows == 1 ? 1.0 : std::sqrt(design.correlation),
               by_row = std::sqrt(1 - by_record * by_record);
  for (std::size_t i = 0; i < records; ++i) {
    const auto z = [&](std::uint32_t k) { return keyed_normal(seed, RandomPurpose::test, i, k); };
    const bool weighted = design.kind == Design::weighted;
    const double a = z(0) - (weighted ? shift : 0.0),
                 weight = weighted ? std::exp(0.5 * (z(0) * z(0) - a * a)) : 1.0;
    std::vector<double> exceed(static_cast<std::size_t>(design.levels));
    const auto level = [&](std::size_t j) {
      return design.limit * static_cast<double>(j + 1) / design.levels;
    };
    const int rows = design.uneven ? uneven_rows[i % uneven_rows.size()] : design.rows;
    for (int row = 0; row < rows; ++row) {
      const double e = design.rows == 1 ? 0.0 : z(1 + static_cast<std::uint32_t>(row));
      const double c = std::exp(true_log_std * (by_record * a + by_row * e));
      for (std::size_t j = 0; j < exceed.size(); ++j) exceed[j] += c < level(j) ? 1.0 : 0.0;
      const bool reached = c < design.limit;
      data.capacities.push_back({reached ? c : design.limit, reached ? c : infinity, weight, i});
    }
    for (std::size_t j = 0; j < exceed.size() && design.kind == Design::counts; ++j)
      data.counts.push_back({level(j), static_cast<double>(design.rows), exceed[j], 1.0, i});
  }
  return data;
}

FitSummary fit_of(const Data& data) {
  return data.counts.empty() ? fit_brackets(data.capacities, Independent::records)
                             : fit_stripes(data.counts, Independent::records);
}

/// Mean and ln standard deviation of complete ln capacities, with standard errors over the records.
struct Moments {
  double mean = 0.0, ln_std = 0.0, mean_error = 0.0, ln_std_error = 0.0;
};

/// @param rows ln capacities, by record
Moments moments(const std::vector<const std::vector<double>*>& rows) {
  const auto n = static_cast<double>(rows.size()), of_record = static_cast<double>(rows[0]->size());
  Moments of;
  for (const auto* record : rows)
    for (const double y : *record) of.mean += y / (n * of_record);
  std::vector<double> shifts, spreads;
  double variance = 0.0;
  for (const auto* record : rows) {
    double shift = 0.0, spread = 0.0;
    for (const double y : *record) {
      shift += (y - of.mean) / of_record;
      spread += (y - of.mean) * (y - of.mean) / of_record;
    }
    variance += spread / n;
    shifts.push_back(shift);
    spreads.push_back(spread);
  }
  of.ln_std = 0.5 * std::log(variance * n * of_record / (n * of_record - 1));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    of.mean_error += shifts[i] * shifts[i] / (n * (n - 1));
    of.ln_std_error += std::pow((spreads[i] / variance - 1) / 2, 2) / (n * (n - 1));
  }
  of.mean_error = std::sqrt(of.mean_error);
  of.ln_std_error = std::sqrt(of.ln_std_error);
  return of;
}

/// Bootstrap-t over records (Efron & Tibshirani 1993, An Introduction to the Bootstrap, 12.5) of
/// median and log_std. Resamples of one record have no error and count at the ends.
std::array<Interval, 2> bootstrap_t(const std::vector<Bracket>& capacities, std::size_t records,
                                    std::uint64_t seed) {
  constexpr std::size_t resamples = 399, tail = 10;  // 2.5 % of 400
  std::vector<std::vector<double>> rows(records);
  for (const Bracket& c : capacities) rows[c.record].push_back(std::log(c.low));
  std::vector<const std::vector<double>*> chosen;
  for (const auto& record : rows) chosen.push_back(&record);
  const Moments of = moments(chosen);
  std::array<std::vector<double>, 2> t;
  for (std::uint32_t k = 0; k < resamples; ++k) {
    for (std::size_t i = 0; i < records; ++i)
      chosen[i] = &rows[static_cast<std::size_t>(static_cast<double>(records) *
                                                 keyed_uniform(seed, RandomPurpose::test, i, k))];
    const Moments again = moments(chosen);
    t[0].push_back(again.mean_error > 0 ? (again.mean - of.mean) / again.mean_error : 0.0);
    t[1].push_back(again.ln_std_error > 0 ? (again.ln_std - of.ln_std) / again.ln_std_error
                                          : -infinity);
  }
  const auto interval = [&](std::vector<double>& ratios, double value, double error) {
    std::ranges::sort(ratios);
    return Interval{std::exp(value - error * ratios[resamples - tail]),
                    std::exp(value - error * ratios[tail - 1])};
  };
  return {interval(t[0], of.mean, of.mean_error), interval(t[1], of.ln_std, of.ln_std_error)};
}

/// Displacements of one record: ln D = 0.8 (sqrt(0.7) a + sqrt(0.3) e), a by record and e by
/// sample.
constexpr double displacement_log_std = 0.8;
double displacement(std::uint64_t seed, std::size_t record, int sample) {
  const auto z = [&](std::uint32_t k) {
    return keyed_normal(seed, RandomPurpose::test, record, k);
  };
  return std::exp(
      displacement_log_std *
      (std::sqrt(0.7) * z(0) + std::sqrt(0.3) * z(1 + static_cast<std::uint32_t>(sample))));
}

void add_percentiles(CoverageCases& cases, std::size_t records) {
  constexpr int samples = 20;
  Results results;
  results.histories = {records, samples, 1, 0, {}};
  results.histories.fields.peak_displacement_m.resize(records * samples);
  for (const double percentile : {0.5, 0.84}) {
    const double truth = std::exp(displacement_log_std * normal_quantile(percentile));
    test::CoverageShare share;
    int below = 0;  // the upper end is: on the unsafe side
    for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(sets()); ++i) {
      for (std::size_t record = 0; record < records; ++record)
        for (int sample = 0; sample < samples; ++sample)
          results.histories.fields.peak_displacement_m[results.histories.at(
              record, static_cast<std::size_t>(sample), 0)] =
              displacement(800000 + i, record, sample);
      const Interval interval =
          exceeded_displacement(results, {0, samples}, 0, 1 - percentile).interval;
      share.add(interval, truth);
      below += interval.high < truth;
    }
    const std::string quantity =
        fmt::format("{:.0f}th percentile of displacement", 100 * percentile);
    cases.add({.group = "percentiles of displacement",
               .records = records,
               .data = "20 samples each",
               .quantity = quantity,
               .share = share.value(),
               .high = 1.0,
               .reference = "nominal 95 %, wide"});
    cases.add({.group = "the same, upper end above the truth",
               .records = records,
               .data = "20 samples each",
               .quantity = quantity + ", upper end",
               .share = 1 - below / static_cast<double>(sets()),
               .low = 0.965,
               .high = 1.0,
               .reference = "nominal 97.5 %, wide"});
  }
}

/// A mean over records: of displacements, or of annual rates.
struct Mean {
  const char* name;
  double log_std, least;  ///< normal z of the least value
  double low;             ///< that must be covered
};
constexpr std::array means = {
    Mean{"mean of displacement", 0.8, -infinity, 0.93},
    Mean{"mean of displacement", 1.0, -infinity, 0.93},
    Mean{"annual rate", 1.4, -infinity, 0.93},
    Mean{"annual rate, log_std 2", 2.0, -infinity, 0.91},
    Mean{"annual rate, log_std 2.5", 2.5, -infinity, 0.89},
    Mean{"annual rate that three in ten records carry", 1.0, 0.5244, 0.88}};

void add_means(CoverageCases& cases, std::size_t records) {
  for (const Mean& mean : means) {
    const double least = std::exp(mean.log_std * mean.least), s = mean.log_std;
    const double truth = std::exp(0.5 * s * s) * normal_cdf(s - mean.least) +
                         (least > 0 ? least * normal_cdf(mean.least) : 0.0);
    test::CoverageShare share;
    for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(sets()); ++i) {
      std::vector<double> values;
      for (std::size_t record = 0; record < records; ++record)
        values.push_back(std::max(
            least, std::exp(s * keyed_normal(900000 + i, RandomPurpose::test, record, 0))));
      share.add(positive_mean_interval(values), truth);
    }
    cases.add({.group = mean.name,
               .records = records,
               .data = fmt::format("log_std {:g} between records", s),
               .quantity = mean.name,
               .share = share.value(),
               .low = mean.low,
               .high = 1.0,
               .reference = "nominal 95 %, wide"});
  }
}

/// Events of two or three records, of ten samples each: ln D = 0.8 (sqrt(0.4) of the event +
/// sqrt(0.4) of the record + sqrt(0.2) of the sample). Capacities are as the displacements.
void add_events(CoverageCases& cases, std::size_t events) {
  constexpr std::size_t samples = 10;
  Results results;
  std::vector<std::size_t>& unit_of = results.histories.unit_of;
  for (std::size_t event = 0; event < events; ++event)
    unit_of.insert(unit_of.end(), 2 + event % 2, event);
  HistoryTable& table = results.histories;
  table.records = unit_of.size();
  table.cases = samples;
  table.levels = 1;
  HistoryValues<double>& all = table.fields.peak_displacement_m;
  all.resize(table.records * samples);
  const double s = displacement_log_std, mean = std::exp(0.5 * s * s);
  struct Covered {
    const char* quantity;
    double truth, high;
    test::CoverageShare share = {};
  };
  std::array covered = {
      Covered{"median of displacement", 1.0, 1.0},
      Covered{"84th percentile of displacement", std::exp(s * normal_quantile(0.84)), 1.0},
      Covered{"mean of displacement", mean, 1.0},
      Covered{"median, fitted on capacities", 1.0, 0.97},
      Covered{"log_std, fitted on capacities", s, 0.97}};
  test::CoverageShare apart;  // each record taken as independent
  for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(sets()); ++i) {
    std::vector<Bracket> capacities;
    std::vector<double> means(table.records);
    for (std::size_t record = 0; record < table.records; ++record) {
      const auto z = [&](std::uint64_t item, std::uint32_t k) {
        return keyed_normal(600000 + i, RandomPurpose::test, item, k);
      };
      for (std::uint32_t k = 0; k < samples; ++k) {
        const double d = std::exp(s * (std::sqrt(0.4) * (z(unit_of[record], 0) + z(record, 1)) +
                                       std::sqrt(0.2) * z(record, 2 + k)));
        all[table.at(record, k, 0)] = d;
        means[record] += d / samples;
        capacities.push_back({d, d, 1.0, unit_of[record]});
      }
    }
    const FitSummary fit = fit_brackets(capacities, Independent::records);
    const std::array found = {exceeded_displacement(results, {0, samples}, 0, 0.5).interval,
                              exceeded_displacement(results, {0, samples}, 0, 0.16).interval,
                              positive_mean_interval(table.by_unit(means)), fit.median_interval,
                              fit.log_std_interval};
    for (std::size_t q = 0; q < found.size(); ++q) covered[q].share.add(found[q], covered[q].truth);
    apart.add(positive_mean_interval(means), mean);
  }
  const auto add = [&](const char* group, const Covered& of, double low, const char* reference) {
    cases.add({group, events, "events of two or three records", of.quantity, of.share.value(), low,
               of.high, reference});
  };
  for (const Covered& of : covered)
    add(of.high < 1 ? "events of two or three records, fits"
                    : "events of two or three records, displacements",
        of, 0.93, of.high < 1 ? "nominal 95 %" : "nominal 95 %, wide");
  add("events, mean, records taken as independent (not used by studies)",
      {"mean, records taken as independent", mean, 0.93, apart}, 0.7, "a trap");
}

}  // namespace

void add_coverage_of_means(CoverageCases& cases) {
  for (const std::size_t records : {7, 20, 44}) {
    add_percentiles(cases, records);
    add_means(cases, records);
    add_events(cases, records);
  }
}

void CoverageCases::add(const CoverageRow& row) {
  cases_.push_back(
      within({std::to_string(row.records) + " records" + (row.data.empty() ? "" : ", ") + row.data,
              row.quantity, row.reference},
             {"share of intervals that cover", row.share, row.low, row.high}));
  auto group = std::ranges::find(groups_, row.group, [](const auto& g) { return g.first; });
  if (group == groups_.end()) group = groups_.insert(group, {row.group, {}});
  const auto range = group->second.try_emplace(row.records, row.share, row.share).first;
  range->second.low = std::min(range->second.low, row.share);
  range->second.high = std::max(range->second.high, row.share);
}

std::string CoverageCases::table() const {
  std::string text = "| | 7 records | 20 records | 44 records |\n|---|---|---|---|\n";
  for (const auto& [group, ranges] : groups_) {
    text += "| " + group;
    for (const std::size_t records : {7, 20, 44}) {
      const auto at = ranges.find(records);
      text += " |";
      if (at == ranges.end()) continue;
      const std::string low = fmt::format("{:.1f}", 100 * at->second.low),
                        high = fmt::format("{:.1f}", 100 * at->second.high);
      text += low == high ? " " + low : fmt::format(" {} to {}", low, high);
    }
    text += " |\n";
  }
  return text;
}

void add_coverage_of_fits(CoverageCases& cases) {
  for (const Design& design : designs) {
    for (const std::size_t records : {7, 20, 44}) {
      const bool is_resampled = design.kind == Design::complete && !design.uneven;
      test::CoverageShare median, log_std, resampled_median, resampled_log_std;
      for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(sets()); ++i) {
        const Data data = data_of(design, records, 700000 + i);
        if (is_resampled) {
          const auto resampled = bootstrap_t(data.capacities, records, 800000 + i);
          resampled_median.add(resampled[0], 1.0);
          resampled_log_std.add(resampled[1], true_log_std);
        }
        const FitSummary fit = fit_of(data);
        if (!fit.converged()) continue;
        median.add(fit.median_interval, 1.0);
        log_std.add(fit.log_std_interval, true_log_std);
      }
      for (const auto& [quantity, share] :
           {std::pair("median", median), std::pair("log_std", log_std)})
        cases.add({.group = design.wide ? "`glissade fit`, wide" : "`glissade fit`",
                   .records = records,
                   .data = design.name,
                   .quantity = quantity,
                   .share = share.value(),
                   .low = design.low,
                   .high = design.wide ? 1.0 : 0.97,
                   .reference = design.wide ? "nominal 95 %, wide" : "nominal 95 %"});
      if (!is_resampled) continue;
      for (const auto& [quantity, share] :
           {std::pair("median", resampled_median), std::pair("log_std", resampled_log_std)})
        cases.add({.group = "bootstrap-t over records, complete capacities (not used)",
                   .records = records,
                   .data = design.name,
                   .quantity = std::string(quantity) + ", bootstrap-t",
                   .share = share.value(),
                   .low = 0.88});
    }
  }
}

}  // namespace glissade::verification
