// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/suite/spectra_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "glissade/report/figures.hpp"
#include "glissade/report/format.hpp"
#include "text/study_text.hpp"

namespace glissade {

Figure spectra_figure(const SuiteSpectra& spectra, const SpectraTexts& texts) {
  Figure figure{
      "spectra", "Response spectra of the ground motions, " + texts.scaled,
      fmt::format("suite {}; {} records", texts.suite, spectra.srss_g.size()),
      "Pseudo-acceleration spectra at 5 % damping: square root of the sum of squares "
      "(SRSS) of the two horizontal components of each record (grey; its number is its row in the "
      "table of records), their average" +
          std::string(spectra.target_g.empty() ? "" : ", and the target spectrum") +
          ". Suite: " + texts.suite + ", " + texts.scaled + "."};
  DataSeries records{DataSeries::Kind::line, look(Role::record), "records",
                     "each record, SRSS of its horizontal components"};
  for (const std::vector<double>& record : spectra.srss_g) {
    for (std::size_t p = 0; p < record.size(); ++p) {
      records.x.push_back(spectra.periods_s.at(p));
      records.y.push_back(record[p]);
    }
    end_line(records);
  }
  Look average = look(Role::mean);
  average.dash = 1;
  average.width = 3.0;
  Panel panel{"",
              {"Period (s)", 0.0, spectra.periods_s.empty() ? 1.0 : spectra.periods_s.back()},
              {"Spectral acceleration, 5 % damped, SRSS (g)"},
              {records,
               {DataSeries::Kind::line, average, "average", "average of the records",
                spectra.periods_s, spectra.average_srss_g}}};
  // Each record's number on its line, at a period of its own.
  const double count = static_cast<double>(spectra.srss_g.size());
  for (std::size_t r = 0; r < spectra.srss_g.size() && !spectra.periods_s.empty(); ++r) {
    const double period_s =
        panel.x.high * std::pow((static_cast<double>(r) + 1.0) / (count + 1.0), 1.4);
    const auto at = std::ranges::lower_bound(spectra.periods_s, period_s);
    const auto p = static_cast<std::size_t>(at - spectra.periods_s.begin());
    if (p < spectra.srss_g[r].size())
      panel.notes.push_back(
          {spectra.periods_s[p], spectra.srss_g[r][p], fmt::format("{}", r + 1), {0x444444}});
  }
  if (!spectra.target_g.empty())
    panel.series.push_back({DataSeries::Kind::line, look(Role::target), "target", texts.target,
                            spectra.periods_s, spectra.target_g});
  panel.y.high = 2.0 * std::max(largest(spectra.average_srss_g), largest(spectra.target_g));
  figure.panels = {std::move(panel)};
  return figure;
}

Figure spectra_figure(const Results& results) {
  const double level_g = results.suites.front().spectra.reference_level;
  return spectra_figure(results.suites.front().spectra,
                        {results.suites.front().name,
                         level_g > 0.0 ? "scaled to S_DS = " + format_number(level_g) + " g"
                                       : "scaled by the suite's own factors",
                         "target (design spectrum)"});
}

}  // namespace glissade
