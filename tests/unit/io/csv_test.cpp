// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/io/csv.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace glissade {
namespace {

TEST(csv_table, quotes_what_needs_it_and_keeps_numbers_exact) {
  CsvTable table({"name", "slip_m", "count"});
  table.cell("a, \"b\"").cell(0.1).cell(std::uint64_t{7}).end_row();
  table.cell("").cell(std::numeric_limits<double>::infinity()).cell(std::uint64_t{0}).end_row();
  EXPECT_EQ(table.text(), "name,slip_m,count\n\"a, \"\"b\"\"\",0.1,7\n,inf,0\n");
}

TEST(csv_table, refuses_a_row_of_another_length) {
#ifdef GLISSADE_CONTRACTS
  CsvTable table({"a", "b"});
  table.cell(1.0);
  EXPECT_THROW(table.end_row(), std::logic_error);
#else
  GTEST_SKIP() << "contracts are off";
#endif
}

TEST(shortest_decimal, reads_back_as_the_same_number) {
  for (const double x : {0.1, 1.0 / 3, 1e-300, 6.02e23, -0.0})
    EXPECT_EQ(std::stod(shortest_decimal(x)), x);
  EXPECT_EQ(shortest_decimal(std::nan("")), "nan");
}

}  // namespace
}  // namespace glissade
