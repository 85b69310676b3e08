// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/core/finite.hpp"
#include "glissade/report/format.hpp"
#include "glissade/report/tables.hpp"
#include "text/study_text.hpp"

namespace glissade {
Table standards_table(const Results& results) {
  using C = StandardComparison;
  TableOf<RunResults, C> t(
      "standards",
      "Displacements prescribed by standards beside the computed slip. " + in_plan(results));
  t.put_all(run_column, standard_column, sds_column, prescribed_column);
  const auto slip = [&](const char* stem, const char* heading, const std::string& description,
                        double SlipStatistics::*value_m) {
    t.length(stem, heading, description, [=](const RunResults& run, const C& at) {
      const SlipStatistics* found = slip_at(run, at.sds_g);
      return found ? found->*value_m : nan;
    });
  };
  const std::string peak = " peak displacement in plan", of_peak = " of the" + peak;
  slip("median_slip", "Median", "median" + peak + " at this level", &SlipStatistics::median_m);
  slip("p84_slip", "84th", "84th percentile" + of_peak, &SlipStatistics::p84_m);
  slip("p95_slip", "95th", "95th percentile" + of_peak, &SlipStatistics::p95_m);
  slip("mean_slip", "Mean", "mean" + peak, &SlipStatistics::mean_m);
  t.share("exceedance_share", "Slip > prescribed",
          "share of histories with more than the prescribed displacement",
          with_interval(&C::exceedance_probability, &C::exceedance_interval));
  t.text("provenance", "Provision", "how well the provision is known",
         [](const C& of) { return provenance_label(of.prescribed.provenance); });
  t.text("basis", "Basis", "equation or clause", [](const C& of) { return of.prescribed.basis; });
  t.add_each(results.runs, &RunResults::standards);
  return with_listed(results, t);
}

}  // namespace glissade
