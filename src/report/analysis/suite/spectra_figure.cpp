// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/suite/spectra_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "glissade/report/figures.hpp"
#include "glissade/report/format.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

constexpr std::size_t most_numbers = 8;
constexpr double text_size = 0.04;  // as a share of the panel

/// Each record's number on its line, where it is farthest from all other lines, and clear of the
/// average, the target and other numbers.
void number_records(const SuiteSpectra& spectra, Panel& panel) {
  const std::vector<double> period_s(spectra.periods_s.begin(),
                                     std::ranges::upper_bound(spectra.periods_s, panel.x.high));
  std::vector<std::vector<double>> lines = spectra.records_g;
  lines.push_back(spectra.average_g);
  if (!spectra.target_g.empty()) lines.push_back(spectra.target_g);
  for (std::size_t r = 0; r < spectra.records_g.size(); ++r) {
    double farthest = -1.0;
    Note number{0.0, 0.0, fmt::format("{}", r + 1), {0x444444}};
    for (std::size_t p = 0; p < period_s.size(); ++p) {
      const auto distance = [&](double x, double y) {
        return std::hypot((x - period_s[p]) / panel.x.high, (y - lines[r][p]) / panel.y.high);
      };
      double least = 1.0;
      for (std::size_t other = 0; other < lines.size(); ++other)
        for (std::size_t q = 0; other != r && q < period_s.size(); ++q)
          least = std::min(least, distance(period_s[q], lines[other][q]) -
                                      (other < spectra.records_g.size() ? 0.0 : text_size));
      for (const Note& other : panel.notes)
        least = std::min(least, distance(other.x, other.y) - text_size);
      if (least <= farthest) continue;
      farthest = least;
      number.x = period_s[p];
      number.y = lines[r][p];
    }
    panel.notes.push_back(std::move(number));
  }
}

}  // namespace

Figure spectra_figure(const SuiteSpectra& spectra, const SpectraTexts& texts) {
  Figure figure{
      "spectra", "Response spectra of the motions, " + texts.scaled,
      "suite " + texts.suite + "; " + counted(spectra.records_g.size(), "record"),
      "Pseudo-acceleration spectra at 5 % damping: " +
          std::string(is_of_16_2(spectra.rule) ? "maximum over all directions (RotD100)"
                                               : "square root of the sum of squares (SRSS)") +
          " of the two horizontal components of each record (grey" +
          std::string(spectra.records_g.size() > most_numbers
                          ? ""
                          : "; its number is that of the table of records") +
          "), their average" +
          std::string(spectra.target_g.empty() ? "" : ", and the target spectrum") +
          ". Suite: " + texts.suite + ", " + texts.scaled + "."};
  DataSeries records{
      DataSeries::Kind::line, look(Role::record), "records",
      std::string("each record, ") + spectra.combination() + " of its horizontal components"};
  for (const std::vector<double>& record : spectra.records_g) {
    for (std::size_t p = 0; p < record.size(); ++p) records.add(spectra.periods_s.at(p), record[p]);
    records.end_line();
  }
  double to_s = spectra.periods_s.empty() ? 1.0 : spectra.periods_s.back();
  if (texts.to_s > 0.0) to_s = std::min(to_s, texts.to_s);
  Look average = look(Role::mean);
  average.dash = 1;
  average.width = 3.0;
  Panel panel{"",
              {"Period (s)", 0.0, to_s},
              {std::string("Spectral acceleration, 5 % damped, ") + spectra.combination() + " (g)"},
              {records,
               {DataSeries::Kind::line, average, "average", "average of the records",
                spectra.periods_s, spectra.average_g}}};
  if (!spectra.target_g.empty())
    panel.series.push_back({DataSeries::Kind::line, look(Role::target), "target", texts.target,
                            spectra.periods_s, spectra.target_g});
  panel.y.high = 1.05 * std::max(largest(records.y), largest(spectra.target_g));
  if (spectra.records_g.size() <= most_numbers) number_records(spectra, panel);
  figure.panels = {std::move(panel)};
  return figure;
}

Figure spectra_figure(const Results& results) {
  const SuiteSummary& suite = results.suites.front();
  const double level_g = suite.spectra.reference_level;
  Figure figure = spectra_figure(suite.spectra,
                                 {suite.name,
                                  level_g > 0.0 ? "scaled to S_DS = " + level_number(level_g) + " g"
                                                : "scaled by the suite's own factors",
                                  "target (design spectrum)"});
  figure.suite = 0;
  return figure;
}

}  // namespace glissade
