// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace glissade {

/// InputError at `where` unless dt_s is finite and above 0; `text` is how it was written.
void check_step(const std::string& where, const std::string& text, double dt_s);

/// The step a header states, or `wanted`, which may mend one that was printed with too few digits,
/// by 2 %. InputError at `where` otherwise.
double agreed_step(const std::string& where, const std::string& text,
                   const std::optional<double>& stated, const std::optional<double>& wanted);

/// A column of times, as printed.
struct TimeColumn {
  std::vector<double> times_s;
  std::vector<std::size_t> lines;
  double resolution_s = 1.0;  ///< of the last decimal printed, the finest in the column

  void add(double time_s, std::string_view token, std::size_t line);
  void scale(double factor);  ///< of milliseconds
};

/// The step of evenly spaced times, (last - first) / (n - 1) to the fewest decimals that give the
/// last time (1/256 s where those are many and a whole rate gives it too), or `wanted` where the
/// times agree with it. InputError where they are uneven or contradict it.
double step_of(const std::filesystem::path& file, const TimeColumn& column,
               const std::optional<double>& wanted);

}  // namespace glissade
