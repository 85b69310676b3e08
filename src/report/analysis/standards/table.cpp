// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/core/finite.hpp"
#include "glissade/report/format.hpp"
#include "glissade/report/tables.hpp"
#include "text/study_text.hpp"

namespace glissade {
Table standards_table(const Results& results) {
  Table table{
      "standards",
      std::string("Displacements prescribed by standards beside the computed slip. ") +
          in_plan(results),
      {run_column,
       standard_column,
       sds_column,
       prescribed_column,
       {"median_slip", "m", "Median, m (in)", ColumnKind::length,
        "median peak displacement in plan at this level"},
       {"p84_slip", "m", "84th, m (in)", ColumnKind::length,
        "84th percentile of the peak displacement in plan"},
       {"p95_slip", "m", "95th, m (in)", ColumnKind::length,
        "95th percentile of the peak displacement in plan"},
       {"mean_slip", "m", "Mean, m (in)", ColumnKind::length, "mean peak displacement in plan"},
       {"exceedance_share", "", "Slip > prescribed [95 %]", ColumnKind::share,
        "share of histories with more than the prescribed displacement", true},
       text_column("provenance", "Provision", "how well the provision is known"),
       text_column("basis", "Basis", "equation or clause")},
      {}};
  for (const RunResults& run : results.runs) {
    for (const StandardComparison& comparison : run.standards) {
      const SlipStatistics* found = slip_at(run, comparison.sds_g);
      const SlipStatistics slip =
          found ? *found : SlipStatistics{0.0, nan, nan, nan, nan, {}, {}, {}, nan};
      table.add({run.label, standard_name(comparison.standard), comparison.sds_g,
                 comparison.prescribed.value_m, slip.median_m, slip.p84_m, slip.p95_m, slip.mean_m,
                 Estimate{comparison.exceedance_probability, comparison.exceedance_interval},
                 provenance_label(comparison.prescribed.provenance), comparison.prescribed.basis});
    }
  }
  return with_listed(results, table);
}

}  // namespace glissade
