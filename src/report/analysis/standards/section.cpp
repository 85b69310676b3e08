// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/standards/section.hpp"

#include <set>

#include "analysis/analyses.hpp"
#include "page/page.hpp"

namespace glissade {
namespace {

/// The provisions of one provenance, each once.
std::vector<std::string> provisions(const Results& results, Provenance provenance) {
  std::set<std::string> found;
  const auto add = [&](const Prescription& prescribed) {
    if (prescribed.provenance == provenance) found.insert(prescribed.basis);
  };
  for (const RunResults& run : results.runs) {
    for (const StandardComparison& c : run.standards) add(c.prescribed);
  }
  if (results.chart) {
    for (const ChartPrescription& p : results.chart->standards) add(p.prescribed);
  }
  return {found.begin(), found.end()};
}

/// What is prescribed and on what basis; what is recalled must be verified before anyone relies on
/// it.
Html provisions_html(const Results& results) {
  Html html;
  const std::vector<std::string> checked = provisions(results, Provenance::checked);
  const std::vector<std::string> recalled = provisions(results, Provenance::recalled);
  if (!checked.empty()) html += paragraph("Checked against a source:") + list(checked);
  if (!recalled.empty()) {
    html +=
        "<div class=\"warning\"><p><strong>Verify against the standard.</strong> These provisions "
        "are recalled from memory of the standard, not reproduced from it:</p>\n" +
        list(recalled) + "</div>\n";
  }
  return html;
}

}  // namespace

Html standards_html(const Results& results, const Table& standards) {
  if (standards.rows.empty()) return {};
  return heading("Standards beside the results") + provisions_html(results) +
         wide_table(standards.without("basis"));
}

/// In the sections of fragility and chart, which compare with them.
AnalysisReport StandardsAnalysis::in_report() { return {}; }

}  // namespace glissade
