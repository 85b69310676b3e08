// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/io/fit_input.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "temporary_folder.hpp"

namespace glissade {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

std::string counts_error(const std::string& content) {
  const TemporaryFolder folder;
  return message_of([&] { read_counts(folder.write("counts.csv", content)); });
}
std::vector<std::size_t> counts_lines(const std::string& content) {
  const TemporaryFolder folder;
  return lines_of([&] { read_counts(folder.write("counts.csv", content)); });
}
std::string capacities_error(const std::string& content) {
  const TemporaryFolder folder;
  return message_of([&] { read_capacities(folder.write("capacities.csv", content)); });
}

TEST(counts_file, is_read_with_comments_blanks_and_either_line_end) {
  const TemporaryFolder folder;
  const CountsInput counts = read_counts(folder.write(
      "c.csv", "# source\r\nim, num_gms ,num_exceed\r\n0.2,40,0\r\n\r\n 0.4 , 40 , 6\r\n"));
  ASSERT_EQ(counts.rows.size(), 2u);
  EXPECT_EQ(counts.rows[1].stripe.intensity, 0.4);
  EXPECT_EQ(counts.rows[1].stripe.trials, 40.0);
  EXPECT_EQ(counts.rows[1].stripe.exceedances, 6.0);
  EXPECT_FALSE(counts.has.record || counts.has.weight);
}

TEST(counts_file, reports_every_wrong_row_with_its_line) {
  EXPECT_THAT(counts_lines("im,num_gms,num_exceed\n0.2,40,41\n0,40,1\n0.3,40,-1\n0.4,40,1.5\n0.5,0,"
                           "0\n0.6,40\n0.7,40,x\n0.8,9,1\n0.8,9,2\nnan,1,1\n"),
              ElementsAre(2, 3, 4, 5, 6, 7, 8, 10, 11));
}

TEST(counts_file, needs_its_header_and_rows) {
  EXPECT_THAT(counts_error("0.2,40,1\n"),
              AllOf(HasSubstr("counts.csv:1"), HasSubstr("im,num_gms,num_exceed")));
  EXPECT_THAT(counts_error(""), HasSubstr("empty"));
  EXPECT_THAT(counts_error("im,num_gms,num_exceed\n"), HasSubstr("no rows"));
}

TEST(capacities_file, is_one_column_of_positive_numbers) {
  const TemporaryFolder folder;
  const CapacitiesInput capacities =
      read_capacities(folder.write("c.csv", "# c\nim_cap\n0.5\n1.25\n0.5\n"));
  ASSERT_EQ(capacities.rows.size(), 3u);
  EXPECT_EQ(capacities.rows[1].low, 1.25);
  EXPECT_EQ(capacities.rows[1].high, 1.25);
  EXPECT_FALSE(capacities.brackets);
  EXPECT_THAT(capacities_error("im_cap\n0.5\n-1\ninf\n"),
              AllOf(HasSubstr("capacities.csv:3: im_cap"), HasSubstr("capacities.csv:4: 'inf'")));
  EXPECT_THAT(capacities_error("0.5\n"), HasSubstr("im_cap"));
}

TEST(fit_file, has_records_and_weights_in_any_column) {
  const TemporaryFolder folder;
  const CountsInput counts = read_counts(folder.write(
      "c.csv",
      "record,num_exceed,weight,im,num_gms\nRSN2,1,0.5,0.4,8\nRSN1,3,2,0.4,8\nRSN2,8,0,0.8,8\n"));
  ASSERT_EQ(counts.rows.size(), 3u);
  EXPECT_TRUE(counts.has.record && counts.has.weight);
  EXPECT_EQ(counts.rows[0].record, counts.rows[2].record);
  EXPECT_NE(counts.rows[0].record, counts.rows[1].record);
  EXPECT_EQ(counts.rows[1].stripe.exceedances, 3.0);
  EXPECT_EQ(counts.rows[1].weight, 2.0);
  EXPECT_EQ(counts.rows[2].weight, 0.0);
}

TEST(fit_file, reports_weights_that_are_none_and_counts_given_twice) {
  EXPECT_THAT(counts_error("im,num_gms,num_exceed,record,weight\n0.2,4,0,a,-1\n0.2,4,5,a,1\n"),
              AllOf(HasSubstr("counts.csv:2: weight"), HasSubstr("counts.csv:3: num_exceed")));
  EXPECT_THAT(counts_error("im,num_gms,num_exceed,record,weight\n0.2,4,0,a,0\n"),
              HasSubstr("weight"));
  EXPECT_THAT(counts_error("im,num_gms,num_exceed,record\n0.2,4,0,a\n0.2,4,1,b\n0.2,4,1,a\n"),
              AllOf(HasSubstr("counts.csv:4"), HasSubstr("line 2")));
}

TEST(capacities_file, has_brackets) {
  const TemporaryFolder folder;
  const CapacitiesInput capacities =
      read_capacities(folder.write("c.csv", "im_low,im_high\n0,0.5\n0.5,1\n2,inf\n"));
  EXPECT_TRUE(capacities.brackets);
  ASSERT_EQ(capacities.rows.size(), 3u);
  EXPECT_EQ(capacities.rows[0].low, 0.0);
  EXPECT_TRUE(std::isinf(capacities.rows[2].high));
  EXPECT_THAT(capacities_error("im_low,im_high\n1,0.5\n0,0\n"),
              AllOf(HasSubstr("capacities.csv:2"), HasSubstr("capacities.csv:3")));
}

TEST(cloud_file, is_intensities_and_displacements) {
  const TemporaryFolder folder;
  const CloudInput cloud = read_cloud(folder.write("c.csv", "im,edp\n0.5,0\n1,0.25\n"));
  ASSERT_EQ(cloud.rows.size(), 2u);
  EXPECT_EQ(cloud.rows[1].displacement, 0.25);
  EXPECT_THAT(message_of([&] { read_cloud(folder.write("d.csv", "im,edp\n0,1\n1,-1\n")); }),
              AllOf(HasSubstr("d.csv:2: im"), HasSubstr("d.csv:3: edp")));
}

}  // namespace
}  // namespace glissade
