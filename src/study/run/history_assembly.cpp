// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/run/history_assembly.hpp"

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <utility>

#include "glissade/core/contract.hpp"

namespace glissade {
namespace {

/// Copies `count` values of every field that is kept, of one case of one record.
void copy_case(const HistoryTable& table, const HistoryFields& from, std::size_t from_case,
               HistoryFields& to, std::size_t to_case) {
  for_each_history_field([&](auto field) {
    if ((to.*field.of).empty()) return;
    const auto depth = static_cast<std::ptrdiff_t>(table.depth(field.depth));
    std::copy_n((from.*field.of).begin() + static_cast<std::ptrdiff_t>(from_case) * depth, depth,
                (to.*field.of).begin() + static_cast<std::ptrdiff_t>(to_case) * depth);
  });
}

/// A mirrored history ends on the other side.
void mirror_residuals(const Plan& plan, HistoryTable& table) {
  auto& across = table.fields.residual_across_m;
  if (across.empty()) return;
  for (std::size_t i = 0; i < table.cases; ++i) {
    const Orientation run = plan.cases[plan.same_as[i]].orientation;
    if (plan.cases[i].orientation.across_sign == run.across_sign) continue;
    for (std::size_t record = 0; record < table.records; ++record) {
      for (std::size_t level = 0; level < table.levels; ++level) {
        double& residual = across[table.at(record, i, level)];
        residual = residual == 0.0 ? 0.0 : -residual;
      }
    }
  }
}

/// Leaves the cases of the first samples of each combination.
void keep_first_samples(const CaseGrid& all, const CaseGrid& first, HistoryTable& table) {
  for (std::size_t record = 0; record < table.records; ++record) {
    for (std::size_t i = 0; i < first.size(); ++i) {
      const std::size_t combination = i / first.per_combination(),
                        from = combination * all.per_combination() + i % first.per_combination();
      copy_case(table, table.fields, record * table.cases + from, table.fields,
                record * first.size() + i);  // never behind what is still to be copied
    }
  }
  table.cases = first.size();
  for_each_history_field([&](auto field) {
    auto& values = table.fields.*field.of;
    if (!values.empty()) values.resize(table.records * table.cases * table.depth(field.depth));
  });
}

}  // namespace

HistoryAssembly::HistoryAssembly(const Plan& plan, const std::filesystem::path& pages)
    : plan_(plan),
      table_{plan.records.size(),
             plan.cases.size(),
             depth_of(plan.config, Depth::levels),
             plan.config.thresholds_m().size(),
             {},
             {}},
      has_(plan.units.size(), false) {
  for (const PlannedRecord& record : plan.records)
    if (plan.config.by_stripes) table_.stripe_of.push_back(record.suite);
  const KeptFields kept(plan.config);
  for_each_history_field([&](auto field) {
    if (!kept.has(field)) return;
    using Values = typename decltype(field)::Values;
    Values& values = table_.fields.*field.of;
    if (!pages.empty()) values = Values(typename Values::allocator_type(pages));
    values.resize(table_.records * table_.cases * table_.depth(field.depth));
  });
}

void HistoryAssembly::add(const UnitResult& unit) {
  const WorkUnit& work = plan_.units.at(unit.unit);
  GLISSADE_EXPECTS(!has_[unit.unit]);
  for (std::size_t i = 0; i < work.count; ++i) {
    copy_case(table_, unit.fields, i, table_.fields,
              work.record * table_.cases + plan_.order[work.first + i]);
  }
  has_[unit.unit] = true;
  count_ += unit.count;
}

HistoryTable HistoryAssembly::take(const Plan& plan) {
  if (!std::all_of(has_.begin(), has_.begin() + static_cast<std::ptrdiff_t>(plan.units.size()),
                   std::identity{}))
    throw std::logic_error("reduce: a unit of the plan is missing");
  for (std::size_t record = 0; record < table_.records; ++record) {
    const std::size_t row = record * table_.cases;
    for (std::size_t i = 0; i < table_.cases; ++i) {
      if (plan_.same_as[i] != i)
        copy_case(table_, table_.fields, row + plan_.same_as[i], table_.fields, row + i);
    }
  }
  mirror_residuals(plan_, table_);
  if (plan.cases.samples < plan_.cases.samples) keep_first_samples(plan_.cases, plan.cases, table_);
  return std::move(table_);
}

}  // namespace glissade
