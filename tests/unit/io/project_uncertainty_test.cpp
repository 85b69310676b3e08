// SPDX-License-Identifier: GPL-3.0-or-later
// What the premises of a project change, beside projects that state the ends.
#include "glissade/core/error.hpp"
#include "glissade/core/finite.hpp"
#include "glissade/fragility/share.hpp"
#include "project_files.hpp"
#include "run_results.hpp"

namespace glissade {
namespace {

using testing::ElementsAre;

class UncertaintyOfProject : public ProjectFiles {
 protected:
  /// As many records as a mean requires, and two more.
  static Suite suite() {
    Suite seven = test::suite_of_five();
    for (const unsigned i : {5u, 6u}) {
      Motion m = seven.motions.front();
      m.id = "motion" + std::to_string(i);
      m.horizontal_mps2 = {test::made_up_record(600, 10 * i + 1, 3.0),
                           test::made_up_record(600, 10 * i + 2, 2.0)};
      seven.motions.push_back(m);
    }
    return seven;
  }
  Results demand(const std::string& text) {
    return test::run(make_plan(demand_of(text), {suite()}));
  }
  Results uncertainty(const std::string& text) {
    return test::run(make_plan(uncertainty_of(text), {suite()}));
  }
  double analysis_m(const std::string& text) {
    return design_clearance(read(text), demand(text), suite()).analysis_m;
  }
  DesignClearance design_of(const std::string& text) {
    const Results found = demand(text);
    DesignClearance design = design_clearance(read(text), found, suite());
    add_model_uncertainty(read(text), found, uncertainty(text), design);
    return design;
  }
  static const PremiseEffect* effect_of(const DesignClearance& design, const std::string& premise) {
    const auto& effects = design.uncertainty.effects;
    const auto found = std::ranges::find(effects, premise, &PremiseEffect::name);
    return found == effects.end() ? nullptr : &*found;
  }
};

TEST_F(UncertaintyOfProject, has_the_displacements_of_projects_that_state_the_ends) {
  const DesignClearance design = design_of(whole_project);
  ASSERT_GT(design.analysis_m, 0.0);
  const auto ends_are = [&](const char* premise, const std::string& low, const std::string& high) {
    const PremiseEffect* effect = effect_of(design, premise);
    ASSERT_NE(effect, nullptr) << premise;
    EXPECT_EQ(effect->result.low, analysis_m(low)) << premise;
    EXPECT_EQ(effect->result.high, analysis_m(high)) << premise;
    EXPECT_EQ(effect->result.calculated, design.analysis_m);
  };
  ends_are("building damping", with("[building]", "damping = 0.025"),
           with("[building]", "damping = 0.1"));
  ends_are("friction, mean", changed("mean = 0.5", "mean = 0.46"),
           changed("mean = 0.5", "mean = 0.54"));
  ends_are("building period, s", changed(period, "period_s = 0.5"),
           changed(period, "period_s = 1.0"));
  ends_are("mass ratio", whole_project, changed(mass_ratio, "mass_ratio = 0.1"));
}

TEST_F(UncertaintyOfProject, of_the_records_is_the_factor_on_the_interval_of_the_mean) {
  const DesignClearance design = design_of(whole_project);
  const PremiseEffect* records = effect_of(design, "records");
  ASSERT_NE(records, nullptr);
  const Interval mean = positive_mean_interval(design.by_record_m);
  EXPECT_EQ(records->result.low, 1.1 * mean.low);
  EXPECT_EQ(records->result.high, 1.1 * mean.high);
}

// Student's t of 6 degrees of freedom at 0.975 is 2.446912 (any table): 0.04 t / sqrt(7).
TEST_F(UncertaintyOfProject, takes_the_interval_of_the_mean_where_the_number_of_tests_is_known) {
  const auto of_seven = friction_ends(read(changed("std = 0.04 }", "std = 0.04 }\ntests = 7")));
  EXPECT_NEAR(of_seven->low, 0.5 - 2.446912 * 0.04 / std::sqrt(7.0), 1e-8);
  EXPECT_NEAR(of_seven->high, 0.5 + 2.446912 * 0.04 / std::sqrt(7.0), 1e-8);
  const auto of_unknown = friction_ends(read(whole_project));
  EXPECT_EQ(of_unknown->low, 0.5 - 0.04);
  EXPECT_FALSE(friction_ends(read(changed("std = 0.04", "std = 0"))));
  const auto of_two =
      friction_ends(read(changed("std = 0.04 }", "std = 0.2 }\ntests = 2")));  // t = 12.7
  EXPECT_EQ(of_two->low, 0.0);
  EXPECT_EQ(of_two->high, 2.0);
}

// tan of the slope is 0.0208: mean 0.12 gives a design friction of 0.04, mean 0.08 one of 0.
TEST_F(UncertaintyOfProject, is_infinite_where_the_array_slides_at_an_end_without_an_earthquake) {
  const std::string text = changed("mean = 0.5", "mean = 0.12");
  EXPECT_THAT(uncertainty_of(text).quantities.at("friction", "mu").values,
              ElementsAre(testing::DoubleNear(0.04, 1e-12), testing::DoubleNear(0.08, 1e-12)));
  const DesignClearance design = design_of(text);
  EXPECT_EQ(design.uncertainty.effects.front().premise, "friction, mean");
  EXPECT_EQ(design.uncertainty.effects.front().result.low, infinity);
}

TEST_F(UncertaintyOfProject, varies_damping_within_its_range) {
  const auto dampings = [&](const char* keys) {
    return dampings_of(read(with("[building]", keys)));
  };
  EXPECT_THAT(dampings("damping = 0.04"), ElementsAre(0.02, 0.04, 0.08));
  EXPECT_THAT(dampings("damping = 0.6"), ElementsAre(0.3, 0.6, 0.999));
  EXPECT_THAT(dampings("damping = 0"), ElementsAre(0.0));
}

}  // namespace
}  // namespace glissade
