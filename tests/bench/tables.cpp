// SPDX-License-Identifier: GPL-3.0-or-later
#include "tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace glissade::bench {
namespace {

double number(std::size_t count) { return static_cast<double>(count); }

const Times& times_of(const WorkPrecision& measured, const std::string& scheme,
                      const std::string& group) {
  return std::ranges::find_if(
             measured.groups,
             [&](const GroupResult& g) { return g.scheme == scheme && g.group == group; })
      ->times;
}

}  // namespace

Table scheme_table(const WorkPrecision& m) {
  Table table{"schemes",
              fmt::format("Time of a history against its error: {} of the standard scenes; errors "
                          "of the peak over those that slide more than 1 mm and do not lift off",
                          m.compared),
              {{"scheme", "", "Scheme", ColumnKind::text},
               {"step", "", "Step", ColumnKind::text},
               {"median_time", "us", "Median, us"},
               {"mean_time", "us", "Mean, us"},
               {"median_time_sliding", "us", "Median of sliding, us"},
               {"judged", "", "Judged", ColumnKind::count},
               {"median_error", "", "Median error"},
               {"largest_error", "", "Largest error"},
               {"worst_scene", "", "Where", ColumnKind::text}},
              {}};
  for (const SchemeResult& s : m.schemes) {
    const bool has_error = s.judged > 0;
    table.add({s.family, s.label, s.all.median_us, s.all.mean_us, s.sliding.median_us,
               number(s.judged), has_error ? Cell(s.median_error) : Cell(""),
               has_error ? Cell(s.largest_error) : Cell(""), s.worst_scene});
  }
  return table;
}

Table group_table(const WorkPrecision& m) {
  Table table{"standard_scenes",
              fmt::format("Time of a history over all {} standard scenes", m.scenes),
              {{"scheme", "", "Scheme", ColumnKind::text},
               {"scenes", "", "Scenes", ColumnKind::text},
               {"histories", "", "Histories", ColumnKind::count},
               {"median_time", "us", "Median, us"},
               {"mean_time", "us", "Mean, us"}},
              {}};
  for (const GroupResult& g : m.groups)
    table.add({g.scheme, g.group, number(g.times.histories), g.times.median_us, g.times.mean_us});
  return table;
}

Table ratio_table(const WorkPrecision& m) {
  Table table{"ratios",
              "Ratios of times of this run",
              {{"ratio", "", "Ratio", ColumnKind::text},
               {"of_medians", "", "Of medians"},
               {"of_means", "", "Of means"}},
              {}};
  const auto add = [&](const std::string& name, const Times& above, const Times& below) {
    table.add({name, above.median_us / below.median_us, above.mean_us / below.mean_us});
  };
  const std::string floor = m.groups.front().scheme;
  const auto published = std::ranges::find_if(m.schemes, [](const SchemeResult& s) {
    return s.family.starts_with("Rodriguez") && s.label == "P = 64";
  });
  for (const GroupResult& g : m.groups) {
    if (g.group != "all" || g.scheme == floor) continue;
    add(g.scheme + " / one maximum-pass, without vertical",
        times_of(m, g.scheme, "without vertical"), times_of(m, floor, "without vertical"));
    add(g.scheme + ", with vertical / without", times_of(m, g.scheme, "with vertical"),
        times_of(m, g.scheme, "the same without it"));
    if (published == m.schemes.end()) continue;  // a quick run stops before P = 64
    const auto own = std::ranges::find(m.schemes, g.scheme, &SchemeResult::family);
    add("Rodriguez-Nikl at P = 64 / " + g.scheme, published->all, own->all);
    add("the same where it slides", published->sliding, own->sliding);
  }
  return table;
}

Table agreement_table(const WorkPrecision& m) {
  Table table{"agreement",
              fmt::format("How far exact schemes are apart in peak slip over all {} standard "
                          "scenes, uplift and free sliders included",
                          m.scenes),
              {{"schemes", "", "Schemes", ColumnKind::text},
               {"sliding", "", "Slide 1 mm", ColumnKind::count},
               {"largest_difference", "", "Relative, those"},
               {"largest_still_difference", "m", "Others, m"},
               {"worst_scene", "", "Where", ColumnKind::text}},
              {}};
  for (const Agreement& a : m.agreements)
    table.add({a.schemes, number(a.histories), a.largest_difference, a.largest_still_difference_m,
               a.worst_scene});
  return table;
}

Table roof_table(const RoofTimes& times) {
  Table table{"roofs",
              "Time to tabulate the response of sixteen oscillators to 8,000 samples, by node and "
              "oscillator",
              {{"part", "", "Part", ColumnKind::text}, {"time", "ns", "Time, ns"}},
              {}};
  table.add({"filter: a, V and U at the nodes", times.filter_ns});
  table.add({"bounds for the search", times.bounds_ns});
  table.add({"tabulate_responses(), whole", times.whole_ns});
  table.add({"the ground itself, once a record, by sample", times.ground_ns});
  return table;
}

Table fragility_table(const FragilityError& m) {
  const auto truth = [](const FragilityTruth& t) {
    return fmt::format("median {:.4g} g (+- {:.1g} of it), log_std {:.4g} (+- {:.1g} of it)",
                       t.median_pga_g, t.median_uncertainty, t.log_std, t.log_std_uncertainty);
  };
  Table table{"fragility",
              fmt::format("{}. Truth of the fit on counts: {}; on capacities: {}", m.study,
                          truth(m.of_counts), truth(m.of_capacities)),
              {{"estimator", "", "Estimator", ColumnKind::text},
               {"samples", "", "Samples", ColumnKind::count},
               {"histories", "", "Histories", ColumnKind::count},
               {"histories_time", "s", "Histories, s"},
               {"fit_time", "s", "Fit, s"},
               {"fitted", "", "Fitted", ColumnKind::count},
               {"median_rms_error", "", "Error of median", ColumnKind::number, "", true},
               {"log_std_rms_error", "", "Error of log_std", ColumnKind::number, "", true}},
              {}};
  const auto cell = [](const RmsError& e) { return NumberCell({e.rms, {e.low, e.high}}); };
  for (const FragilityErrorRow& row : m.rows) {
    table.add({row.estimator.name(), std::ldexp(1.0, row.log2_samples), row.histories,
               row.histories_s, row.fit_s, static_cast<double>(row.fitted), cell(row.median),
               cell(row.log_std)});
  }
  return table;
}

Table histories_table(const FragilityError& m) {
  constexpr double error = 0.01;
  Table table{"histories_for_an_error",
              "Histories for a root mean square error of 1 % of the median, and how many times as "
              "many plain Monte Carlo (counts at the levels) needs",
              {{"estimator", "", "Estimator", ColumnKind::text},
               {"histories", "", "Histories"},
               {"plain_over_this", "", "Plain over this"}},
              {}};
  const double plain = histories_for(rows_of(m, estimators().front()), error);
  for (const Estimator& estimator : estimators()) {
    const double needed = histories_for(rows_of(m, estimator), error);
    table.add({estimator.name(), needed, plain / needed});
  }
  return table;
}

Table trial_table(const std::string& name, const std::string& title,
                  const std::vector<SchemeResult>& results) {
  Table table{name,
              title,
              {{"scheme", "", "Scheme", ColumnKind::text},
               {"step", "", "Step", ColumnKind::text},
               {"histories", "", "Histories", ColumnKind::count},
               {"median_time", "us", "Median, us"},
               {"mean_time", "us", "Mean, us"},
               {"passes", "", "Passes"},
               {"median_error", "", "Median error"},
               {"largest_error", "", "Largest error"},
               {"worst_scene", "", "Where", ColumnKind::text}},
              {}};
  const double floor_us = results.front().sliding.mean_us;
  for (const SchemeResult& s : results) {
    const bool has_error = s.judged > 0;
    table.add({s.family, s.label, number(s.sliding.histories), s.sliding.median_us,
               s.sliding.mean_us, s.sliding.mean_us / floor_us,
               has_error ? Cell(s.median_error) : Cell(""),
               has_error ? Cell(s.largest_error) : Cell(""), s.worst_scene});
  }
  return table;
}

bool is_complete(const Table& table) {
  return !table.rows.empty() && std::ranges::all_of(table.rows, [](const std::vector<Cell>& row) {
    return std::ranges::all_of(row, [](const Cell& cell) {
      if (const auto* value = std::get_if<double>(&cell)) return std::isfinite(*value);
      if (const auto* e = std::get_if<NumberCell>(&cell))
        return std::isfinite(e->value) && std::isfinite(e->interval.low) &&
               std::isfinite(e->interval.high);
      return true;
    });
  });
}

}  // namespace glissade::bench
