// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/analysis/tipping.hpp"

#include "glissade/core/error.hpp"
#include "glissade/study/plan/kernel.hpp"
#include "glissade/study/results.hpp"

namespace glissade {
namespace {

TippingShare share_at(const Results& results, std::size_t combination, std::size_t level) {
  const CaseSet& set = results.cases;
  const HistoryTable& histories = results.histories;
  const std::size_t first = set.index(combination, 0, 0), cases = set.per_combination();
  TippingShare row{first, set.describe(combination), results.levels[level], 0.0, {}};
  for (std::size_t record = 0; record < histories.records; ++record) {
    double tips = 0.0;
    for (std::size_t i = first; i < first + cases; ++i)
      tips += histories.fields.tips[histories.at(record, i, level)];
    row.by_record.push_back(tips / static_cast<double>(cases));
    row.share += tips;
  }
  row.share /= static_cast<double>(histories.records * cases);
  return row;
}

}  // namespace

TippingResults TippingAnalysis::find(const StudyConfig& study, const Results& results) {
  const RigidBase& body = *study.tipping;
  TippingResults tipping{body, rocking_block({}, body).friction.along, {}};
  for (std::size_t i = 0; i < results.cases.combinations(); ++i) {
    for (std::size_t level = 0; level < results.levels.size(); ++level)
      tipping.shares.push_back(share_at(results, i, level));
  }
  return tipping;
}

void TippingAnalysis::check(const StudyConfig& study, std::size_t, ProblemList& problems) {
  const KernelChoice choice = cheapest_exact_kernel(study);
  if (choice.kernel != Kernel::tables && study.tipping) {
    problems.add(
        {study.file.string(),
         "the tipping check of [tipping] holds where the array does not move its building: " +
             choice.reason,
         "leave out [tipping], or set [model] axes = 1 with an elastic building that is "
         "not coupled",
         ""});
  }
}

}  // namespace glissade
