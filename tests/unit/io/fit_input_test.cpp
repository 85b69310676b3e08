// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/io/fit_input.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "problems.hpp"
#include "temporary_folder.hpp"

namespace glissade {
namespace {

using testing::ElementsAre;

void counts(const std::string& content) {
  const TemporaryFolder folder;
  read_counts(folder.write("counts.csv", content));
}
std::vector<std::size_t> counts_lines(const std::string& content) {
  return lines_of([&] { counts(content); });
}
std::vector<std::string> capacities_faults(const std::string& content) {
  const TemporaryFolder folder;
  return faults_of([&] { read_capacities(folder.write("capacities.csv", content)); });
}

TEST(counts_file, is_read_with_comments_blanks_and_either_line_end) {
  const TemporaryFolder folder;
  const CountsInput counts = read_counts(folder.write(
      "c.csv", "# source\r\nim, num_gms ,num_exceed\r\n0.2,40,0\r\n\r\n 0.4 , 40 , 6\r\n"));
  ASSERT_EQ(counts.rows.size(), 2u);
  EXPECT_EQ(counts.rows[1].intensity, 0.4);
  EXPECT_EQ(counts.rows[1].trials, 40.0);
  EXPECT_EQ(counts.rows[1].exceedances, 6.0);
  EXPECT_FALSE(counts.has.record || counts.has.weight);
}

TEST(counts_file, may_have_what_a_spreadsheet_leaves_behind) {
  const TemporaryFolder folder;
  const CountsInput counts = read_counts(folder.write(
      "c.csv", "\xEF\xBB\xBFim,num_gms,num_exceed,,\n0.2,40,0,,\n,,,,\n0.4,40,6\n,,\n"));
  ASSERT_EQ(counts.rows.size(), 2u);
  EXPECT_EQ(counts.rows[1].exceedances, 6.0);
  EXPECT_THAT(counts_lines("im,num_gms,num_exceed,,\n0.2,40,0,,1\n0.4,40\n"), ElementsAre(2, 3));
}

TEST(counts_file, reports_every_wrong_row_with_its_line) {
  EXPECT_THAT(counts_lines("im,num_gms,num_exceed\n0.2,40,41\n0,40,1\n0.3,40,-1\n0.4,40,1.5\n0.5,0,"
                           "0\n0.6,40\n0.7,40,x\n0.8,9,1\n0.8,9,2\nnan,1,1\n"),
              ElementsAre(2, 3, 4, 5, 6, 7, 8, 10, 11));
}

TEST(counts_file, needs_its_header_and_rows) {
  expect_refusals(counts, {{"0.2,40,1\n", "counts.csv:1", {"im,num_gms,num_exceed"}},
                           {"record,record,im,num_gms,num_exceed\n1,2,0.2,40,1\n",
                            "counts.csv:1",
                            {"is not the header"}},
                           {"", "counts.csv", {}},
                           {"im,num_gms,num_exceed\n", "counts.csv", {}}});
}

TEST(capacities_file, is_one_column_of_positive_numbers) {
  const TemporaryFolder folder;
  const CapacitiesInput capacities =
      read_capacities(folder.write("c.csv", "# c\nim_cap\n0.5\n1.25\n0.5\n"));
  ASSERT_EQ(capacities.rows.size(), 3u);
  EXPECT_EQ(capacities.rows[1].low, 1.25);
  EXPECT_EQ(capacities.rows[1].high, 1.25);
  EXPECT_FALSE(capacities.brackets);
  EXPECT_THAT(capacities_faults("im_cap\n0.5\n-1\ninf\n"), ElementsAre("3 im_cap"));
  EXPECT_THAT(capacities_faults("im_cap,record\n0.5,a\n,b\n-inf,c\n"),
              ElementsAre("3 ''", "4 '-inf'"));
  EXPECT_THAT(capacities_faults("0.5\n"), ElementsAre(testing::StartsWith("1 ")));
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
  EXPECT_EQ(counts.rows[1].exceedances, 3.0);
  EXPECT_EQ(counts.rows[1].weight, 2.0);
  EXPECT_EQ(counts.rows[2].weight, 0.0);
}

// Both records of an earthquake are one unit, and each has its own rows.
TEST(fit_file, takes_the_event_of_records_as_what_is_independent) {
  const TemporaryFolder folder;
  const std::string head = "im,num_gms,num_exceed,record,event\n";
  const CountsInput counts =
      read_counts(folder.write("c.csv", head + "0.4,8,1,a,E1\n0.4,8,3,b,E1\n0.4,8,2,c,E2\n"));
  EXPECT_TRUE(counts.has.event && counts.has.unit());
  EXPECT_EQ(counts.rows[0].record, counts.rows[1].record);
  EXPECT_NE(counts.rows[0].record, counts.rows[2].record);
  for (const auto& [rows, what] :
       {std::pair{"0.4,8,1,a,E1\n0.4,8,3,b,\n", "event is not named here"},
        {"0.4,8,1,a,E1\n0.6,8,3,a,E2\n", "another event"}}) {
    try {
      read_counts(folder.write("d.csv", head + rows));
      ADD_FAILURE();
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr(what));
    }
  }
}

TEST(fit_file, names_two_records_with_the_same_rows) {
  const TemporaryFolder folder;
  const auto same = [&](const std::string& rows) {
    return read_capacities(folder.write("c.csv", "record,im_cap\n" + rows)).same;
  };
  EXPECT_EQ(same("a,0.512345\nb,0.6\nc,0.512345\n"), "a and c");
  EXPECT_EQ(same("a,0.51\nb,0.6\nc,0.51\n"), "");  // may be chance
  EXPECT_EQ(same("a,0.512\na,0.634\nb,0.634\nb,0.512\n"), "a and b");
  EXPECT_EQ(same("a,inf\nb,inf\n"), "");
}

TEST(fit_file, reports_weights_that_are_none_and_counts_given_twice) {
  const std::string head = "im,num_gms,num_exceed,record";
  EXPECT_THAT(faults_of([&] { counts(head + ",weight\n0.2,4,0,a,-1\n0.2,4,5,a,1\n"); }),
              ElementsAre("2 weight", "3 num_exceed"));
  expect_refusals(counts,
                  {{head + ",weight\n0.2,4,0,a,0\n", "counts.csv", {"weight"}},
                   {head + "\n0.2,4,0,a\n0.2,4,1,b\n0.2,4,1,a\n", "counts.csv:4", {"line 2"}}});
}

TEST(capacities_file, has_brackets) {
  const TemporaryFolder folder;
  const CapacitiesInput capacities =
      read_capacities(folder.write("c.csv", "im_low,im_high\n0,0.5\n0.5,1\n2,inf\n"));
  EXPECT_TRUE(capacities.brackets);
  ASSERT_EQ(capacities.rows.size(), 3u);
  EXPECT_EQ(capacities.rows[0].low, 0.0);
  EXPECT_TRUE(std::isinf(capacities.rows[2].high));
  EXPECT_THAT(capacities_faults("im_low,im_high\n1,0.5\n0,0\n"),
              ElementsAre(testing::StartsWith("2 "), testing::StartsWith("3 ")));
}

TEST(cloud_file, is_intensities_and_displacements) {
  const TemporaryFolder folder;
  const CloudInput cloud = read_cloud(folder.write("c.csv", "im,edp\n0.5,0\n1,0.25\n"));
  ASSERT_EQ(cloud.rows.size(), 2u);
  EXPECT_EQ(cloud.rows[1].displacement, 0.25);
  EXPECT_THAT(faults_of([&] { read_cloud(folder.write("d.csv", "im,edp\n0,1\n1,-1\n")); }),
              ElementsAre("2 im", "3 edp"));
}

}  // namespace
}  // namespace glissade
