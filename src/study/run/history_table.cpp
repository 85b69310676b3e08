// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/run/history_table.hpp"

#include <algorithm>
#include <map>
#include <sstream>

#include "glissade/study/cases/case.hpp"
#include "glissade/study/results.hpp"

namespace glissade {
namespace {

/// The words of an event's name in lower case, with one blank after each.
std::string words_of(const std::string& event) {
  std::istringstream words(event);
  std::string text, word;
  while (words >> word) text += word + " ";
  std::ranges::transform(text, text.begin(), [](char c) {
    return 'A' <= c && c <= 'Z' ? static_cast<char>(c + 32) : c;
  });
  return text;
}

}  // namespace

KeptFields::KeptFields(const StudyConfig& config)
    : two_axes(config.two_axes()),
      closing(config.has_neighbours()),
      capacities(!config.by_stripes) {
  for_each_analysis(Analyses(), [&]<class Analysis>(Analysis) {
    if constexpr (requires { Analysis::keeps; }) {
      const auto& [is_asked] = static_cast<const typename Analysis::InStudy&>(config);
      if (is_asked) this->*Analysis::keeps = true;
    }
  });
  by_axis = by_axis && two_axes;
}

std::vector<std::size_t> event_units(const std::vector<std::string>& events) {
  std::map<std::string, std::size_t> numbers;
  std::vector<std::size_t> units;
  std::size_t count = 0;
  for (const std::string& event : events) {
    const std::string name = words_of(event);
    const auto known = name.empty() ? numbers.end() : numbers.try_emplace(name, count).first;
    units.push_back(known == numbers.end() ? count : known->second);
    if (units.back() == count) ++count;
  }
  return numbers.empty() ? std::vector<std::size_t>() : units;
}

std::vector<std::size_t> event_units(const std::vector<RecordSummary>& records) {
  std::vector<std::string> events;
  for (const RecordSummary& record : records) events.push_back(record.event);
  return event_units(events);
}

std::size_t unit_count(const Results& results) {
  return unit_count(results.histories.unit_of, results.records.size());
}

double effective_units(const Results& results) {
  const std::vector<double> ones(results.records.size(), 1.0);
  if (results.histories.unit_of.empty()) return static_cast<double>(ones.size());
  return effective_number(results.histories.by_unit(ones).records);
}

std::size_t depth_of(const StudyConfig& config, Depth depth) {
  const std::size_t levels = config.by_stripes ? 1 : config.intensity.levels.size(),
                    thresholds = config.thresholds_m().size();
  if (depth == Depth::levels) return levels;
  return depth == Depth::thresholds ? thresholds : levels * thresholds;
}

double bytes_of(const StudyConfig& config, std::size_t records, std::size_t cases) {
  const KeptFields kept(config);
  double bytes = 0.0;
  for_each_history_field([&]<class T>(const HistoryField<T>& field) {
    if (kept.has(field)) bytes += static_cast<double>(depth_of(config, field.depth) * sizeof(T));
  });
  return (bytes * static_cast<double>(records) + sizeof(Case)) * static_cast<double>(cases);
}

}  // namespace glissade
