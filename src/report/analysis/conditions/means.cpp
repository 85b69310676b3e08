// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/conditions/means.hpp"

#include <utility>

#include "analysis/conditions/view.hpp"
#include "glissade/core/finite.hpp"
#include "glissade/core/quantile.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

const char* what_is_averaged(ColumnKind kind) {
  return kind == ColumnKind::length
             ? "mean over the suite of the peak displacement in plan"
             : "mean over the suite of the base shear over the weight of the building";
}

/// Which mean a row is.
void put_place(auto& t, const MeansByCondition& of) {
  of.conditions.put_in(t);
  if (of.period != nullptr)
    t.put(*of.period, [grid = ConditionGrid(of.results)](const SuiteMean& mean) {
      return grid.value(ConditionAxis::period, mean.at[ConditionAxis::period]);
    });
}

}  // namespace

Table means_table(const MeansByCondition& of, FileName name, std::string title) {
  using M = SuiteMean;
  TableOf<M> t(std::move(name), std::move(title));
  put_place(t, of);
  const auto put = [&](const char* stem, const char* heading, const std::string& which,
                       auto value) -> Column& {
    return t.put(range_column(stem, heading, which, of.kind), value);
  };
  const std::string mean = what_is_averaged(of.kind);
  put("lowest", "Lowest", mean + ", all records in the least orientation",
      [](const M& m) { return m.range.lowest; });
  put("median", "Median", mean + ", median over the orientations", [](const M& m) -> Cell {
    return Estimate{m.range.median, m.range.interval};
  }).with_interval = true;
  put("highest", "Highest", mean + ", all records in the largest orientation",
      [](const M& m) -> Cell {
        return Estimate{m.range.highest, m.range.highest_interval};
      })
      .with_interval = true;
  // A terminal has no room for all: displacements have their bounds, shears their largest.
  const bool is_length = of.kind == ColumnKind::length;
  put("bound_lowest", "Lower bound", mean + ", each record in its least orientation",
      [](const M& m) { return m.bounds.lowest; })
      .detail = !is_length;
  put("bound_highest", "Upper bound", mean + ", each record in its largest orientation",
      [](const M& m) { return m.bounds.highest; })
      .detail = !is_length;
  put("largest", "Largest history", "largest of all records and orientations", &M::largest).detail =
      is_length;
  t.add_each(of.means);
  t.notes = {"[ ]: 95 % interval, over " + units_name(of.results),
             "bounds: with the orientation chosen record by record"};
  return t;
}

Table means_by_orientation_table(const MeansByCondition& of, FileName name, std::string title) {
  TableOf<SuiteMean, std::size_t> t(std::move(name), std::move(title));
  put_place(t, of);
  t.count("orientation", "Orientation", "orientation of all records: from 1, as in `cases`",
          [](std::size_t o) { return o + 1; });
  t.put(range_column("mean", "Mean", what_is_averaged(of.kind), of.kind),
        [](const SuiteMean& mean, std::size_t o) { return mean.by_orientation[o]; });
  for (const SuiteMean& mean : of.means)
    for (std::size_t o = 0; o < mean.by_orientation.size(); ++o) t.add(mean, o);
  return t;
}

Table ratios_table(const RatiosByCondition& of, FileName name, std::string title) {
  struct Ratios {
    std::size_t suite;
    Condition at;
    std::vector<double> values;
  };
  TableOf<Ratios> t(std::move(name), std::move(title));
  of.conditions.put_in(t);
  const auto put = [&](const char* stem, const char* heading, const char* description,
                       double share) {
    t.number(stem, heading, description,
             [=](const Ratios& r) { return quantile_of(r.values, share); });
  };
  put("lowest", "Lowest", "least orientation", 0.0);
  put("median", "Median", "median over the orientations", 0.5);
  put("highest", "Highest", "largest orientation", 1.0);
  for (const Condition& at : of.places)
    t.add({of.question.suite, at,
           ratios_by_orientation(of.results, of.question, at, of.reference(at))});
  return t;
}

}  // namespace glissade
