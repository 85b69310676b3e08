// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/standards/prescriptive.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "glissade/core/error.hpp"
#include "glissade/core/units.hpp"

namespace glissade {
namespace {

using testing::HasSubstr;
using enum SeismicDesignCategory;

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// Rodriguez-Nikl (2019): S_DS 1.566 g gives 81.6 in, 2,070 mm, as the paper rounds them.
TEST(seaoc_pv1_2012, gives_the_published_displacement) {
  const Prescription prescription = seaoc_pv1_2012_displacement(1.566, d);
  EXPECT_NEAR(prescription.value_m / inch_m, 81.6, 0.05);
  EXPECT_NEAR(prescription.value_m, 2.070, 0.005);
  EXPECT_EQ(prescription.provenance, Provenance::checked);
}

// A stamped permit calculation: S_DS 1.050, I_e 1 gives 25.4 in (5 x 0.65^2 ft = 25.35 in,
// rounded).
TEST(asce7_16, gives_the_displacement_of_a_permit_sheet) {
  const Prescription prescription = asce7_16_displacement(1.050, 1.0);
  EXPECT_NEAR(prescription.value_m / inch_m, 25.35, 1e-9);
  EXPECT_EQ(prescription.provenance, Provenance::checked);
}

TEST(asce7_16, is_the_seaoc_formula_where_both_formulas_govern_and_importance_is_one) {
  EXPECT_NEAR(asce7_16_displacement(1.5, 1.0).value_m, seaoc_pv1_2012_displacement(1.5, e).value_m,
              1e-15);
}

TEST(asce7_16, is_proportional_to_importance) {
  EXPECT_NEAR(asce7_16_displacement(1.5, 1.5).value_m,
              1.5 * asce7_16_displacement(1.5, 1.0).value_m, 1e-15);
}

TEST(seaoc_pv1_2012, floor_is_marked_as_recalled) {
  // 60 x 0.3^2 = 5.4 in is below the 6 in floor; 60 x 0.32^2 = 6.144 in is above.
  const Prescription below = seaoc_pv1_2012_displacement(0.70, d);
  EXPECT_DOUBLE_EQ(below.value_m, 6.0 * inch_m);
  EXPECT_EQ(below.provenance, Provenance::recalled);
  const Prescription above = seaoc_pv1_2012_displacement(0.72, f);
  EXPECT_NEAR(above.value_m / inch_m, 6.144, 1e-12);
  EXPECT_EQ(above.provenance, Provenance::checked);
}

TEST(asce7_16, floor_is_marked_as_recalled) {
  const Prescription below = asce7_16_displacement(1.0, 1.0);  // 5 x 0.6^2 ft = 21.6 in
  EXPECT_DOUBLE_EQ(below.value_m, 24.0 * inch_m);
  EXPECT_EQ(below.provenance, Provenance::recalled);
}

// Without the clamp 60 (0 - 0.4)^2 would be 9.6 in.
TEST(prescriptive_displacements, do_not_grow_again_below_an_sds_of_four_tenths) {
  EXPECT_DOUBLE_EQ(seaoc_pv1_2012_displacement(0.0, d).value_m, 6.0 * inch_m);
  EXPECT_DOUBLE_EQ(asce7_16_displacement(0.0, 1.5).value_m, 24.0 * inch_m);
}

TEST(seaoc_pv1_2012, low_categories_have_six_inches_whatever_the_sds) {
  for (const SeismicDesignCategory category : {a, b, c}) {
    const Prescription prescription = seaoc_pv1_2012_displacement(1.5, category);
    EXPECT_DOUBLE_EQ(prescription.value_m, 6.0 * inch_m);
    EXPECT_EQ(prescription.provenance, Provenance::recalled);
  }
}

TEST(separations, are_half_one_one_and_two_displacements) {
  for (const Standard standard : {Standard::asce7_16, Standard::seaoc_pv1_2012}) {
    const std::vector<Separation> separations = separations_of(standard, 0.7);
    ASSERT_EQ(separations.size(), 4u);
    const double expected_m[] = {0.35, 0.7, 0.7, 1.4};
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_DOUBLE_EQ(separations[i].value_m, expected_m[i]) << separations[i].what;
    EXPECT_THAT(separations[0].what, HasSubstr("similar arrays"));
    EXPECT_THAT(separations[3].what, HasSubstr("without"));
  }
}

// Issue 34: 2 x 19.2 in is 3.2 ft. The evidence of the factors, a permit sheet, is of ASCE 7-16.
TEST(separations, to_an_edge_are_4_ft_or_more_by_ASCE_7_16_and_all_of_SEAOC_PV1_is_recalled) {
  const Separation edge = separations_of(Standard::asce7_16, 19.2 * inch_m).back();
  EXPECT_DOUBLE_EQ(edge.value_m, 4.0 * foot_m);
  EXPECT_EQ(edge.provenance, Provenance::recalled);
  EXPECT_EQ(separations_of(Standard::asce7_16, 25.4 * inch_m).back().provenance,
            Provenance::checked);
  for (const Separation& s : separations_of(Standard::seaoc_pv1_2012, 19.2 * inch_m))
    EXPECT_EQ(s.provenance, Provenance::recalled);
  EXPECT_EQ(separations_of(Standard::seaoc_pv1_2012, 1.0).back().basis, "");
}

TEST(prescriptive_input, negative_or_non_finite_numbers_are_input_errors) {
  for (const double bad : {-0.1, inf, nan}) {
    EXPECT_THROW(seaoc_pv1_2012_displacement(bad, a), InputError);
    EXPECT_THROW(asce7_16_displacement(bad, 1.0), InputError);
    EXPECT_THROW(asce7_16_displacement(1.0, bad), InputError);
    EXPECT_THROW(separations_of(Standard::asce7_16, bad), InputError);
  }
}

TEST(prescriptive_input, all_problems_are_reported_at_once) {
  try {
    asce7_16_displacement(nan, -1.0);
    FAIL() << "nothing thrown";
  } catch (const InputError& error) {
    EXPECT_EQ(error.problems().size(), 2u);
  }
}

TEST(seismic_design_category, reads_what_it_writes) {
  for (const SeismicDesignCategory category : {a, b, c, d, e, f}) {
    EXPECT_EQ(parse_seismic_design_category(to_string(category)), category);
  }
  EXPECT_THROW(parse_seismic_design_category("G"), InputError);
}

}  // namespace
}  // namespace glissade
