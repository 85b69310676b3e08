// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace glissade {

/// A header that a CSV file of numbers may have, and what takes its rows.
struct NumberRows {
  std::vector<std::string_view> header;
  /// Why a row is refused: nothing if it is taken.
  std::function<std::string(const std::vector<double>& values, std::size_t line)> take_row;
};

/// Reads the finite numbers below one of the headers. Throws InputError with the problems of all
/// rows; also where there are none.
void read_number_rows(const std::filesystem::path& file, const std::vector<NumberRows>& known);

}  // namespace glissade
