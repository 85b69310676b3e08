// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/io/fit_input.hpp"

#include <gmock/gmock.h>

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
std::string capacities_error(const std::string& content) {
  const TemporaryFolder folder;
  return message_of([&] { read_capacities(folder.write("capacities.csv", content)); });
}

TEST(counts_file, is_read_with_comments_blanks_and_either_line_end) {
  const TemporaryFolder folder;
  const auto stripes = read_counts(folder.write(
      "c.csv", "# source\r\nim, num_gms ,num_exceed\r\n0.2,40,0\r\n\r\n 0.4 , 40 , 6\r\n"));
  ASSERT_EQ(stripes.size(), 2u);
  EXPECT_EQ(stripes[1].intensity, 0.4);
  EXPECT_EQ(stripes[1].trials, 40.0);
  EXPECT_EQ(stripes[1].exceedances, 6.0);
}

TEST(counts_file, reports_every_wrong_row_with_its_line) {
  EXPECT_THAT(counts_error("im,num_gms,num_exceed\n0.2,40,41\n0,40,1\n0.3,40,-1\n0.4,40,1.5\n0.5,0,"
                           "0\n0.6,40\n0.7,40,x\n0.8,9,1\n0.8,9,2\nnan,1,1\n"),
              AllOf(HasSubstr("counts.csv:2: num_exceed is larger"),
                    HasSubstr("counts.csv:3: im is not above 0"),
                    HasSubstr("counts.csv:4: num_exceed is not a whole"),
                    HasSubstr("counts.csv:5: num_exceed is not a whole"),
                    HasSubstr("counts.csv:6: num_gms is not"),
                    HasSubstr("counts.csv:7: 2 column(s)"), HasSubstr("counts.csv:8: 'x' is not"),
                    HasSubstr("counts.csv:10: this im is already on line 9"),
                    HasSubstr("counts.csv:11: 'nan'")));
}

TEST(counts_file, needs_its_header_and_rows) {
  EXPECT_THAT(counts_error("0.2,40,1\n"),
              AllOf(HasSubstr("counts.csv:1"), HasSubstr("im,num_gms,num_exceed")));
  EXPECT_THAT(counts_error(""), HasSubstr("empty"));
  EXPECT_THAT(counts_error("im,num_gms,num_exceed\n"), HasSubstr("no rows"));
}

TEST(capacities_file, is_one_column_of_positive_numbers) {
  const TemporaryFolder folder;
  EXPECT_THAT(read_capacities(folder.write("c.csv", "# c\nim_cap\n0.5\n1.25\n0.5\n")),
              ElementsAre(0.5, 1.25, 0.5));
  EXPECT_THAT(capacities_error("im_cap\n0.5\n-1\ninf\n"),
              AllOf(HasSubstr("capacities.csv:3: im_cap is below 0"),
                    HasSubstr("capacities.csv:4: 'inf'")));
  EXPECT_THAT(capacities_error("0.5\n"), HasSubstr("is not the header im_cap"));
}

}  // namespace
}  // namespace glissade
