// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "analysis/model_uncertainty/model_uncertainty.hpp"
#include "facts.hpp"
#include "glissade/report/summary.hpp"
#include "glissade/report/tables.hpp"
#include "made_up_results.hpp"

namespace glissade {
namespace {

using test::states;

/// Of premises from 1.75 to 2.25 where 2 is calculated: 25 %.
ModelUncertainty of(AtEnds records) {
  return {0.3,
          {{"building period", "s", "listed", 0.2, 1.0, {1.75, 2.0, 2.25}, {0.1, 0.2, 0.3}},
           {"records", "", "95 % interval", nan, nan, records, {}, true}},
          "building damping 0.05"};
}

TEST(model_uncertainty_report, says_whether_records_or_premises_decide) {
  EXPECT_THAT(deciding_text(of({1.5, 2.0, 2.5})),
              states("records decide", "building period: 25 %", "95 % interval: 50 %"));
  EXPECT_THAT(deciding_text(of({1.9, 2.0, 2.1})), states("premises decide", "95 % interval: 10 %"));
  EXPECT_THAT(deciding_text(of({0.0, 2.0, infinity})), states("records decide", "without limit"));
  EXPECT_THAT(deciding_text(of({})), states("not known", "building period: 25 %"));
  EXPECT_EQ(deciding_text({}), "no premise is varied");
}

TEST(model_uncertainty_report, has_a_row_for_each_premise_and_what_is_not_varied) {
  Results results = made_up_results();
  results.model.dbe_level = 1.0;
  results.uncertainties = {of({1.5, 2.0, 2.5})};
  const Table table = table_named(results, "model_uncertainty");
  ASSERT_EQ(table.rows.size(), 2u);
  EXPECT_THAT(to_csv(table),
              states("\"building period, s\",listed,0.2,1,1.75,2,2.25,0.1,0.2,0.3,0.25"));
  EXPECT_THAT(table.notes, testing::ElementsAre("Not varied: building damping 0.05."));
  EXPECT_THAT(summary_text(results), states("by clearance", "records decide"));
}

}  // namespace
}  // namespace glissade
