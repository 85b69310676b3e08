// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace glissade::gnuplot {

/// A single-quoted gnuplot string. User text (`plain`) shows as it is, no character acting as
/// markup; `S_DS` is set as a symbol.
std::string quoted(std::string_view plain);
/// The same characters escaped for enhanced text, without the quotes: for use inside markup.
std::string enhanced(std::string_view plain);
/// Markup as given, quoted.
std::string quoted_markup(std::string_view markup);

/// The colour (of `count`) at `index`: an ordered ramp that stays ordered in grey and for
/// colour-blind readers (viridis, Smith & van der Walt 2015, without its light end).
std::string ramp_colour(std::size_t index, std::size_t count);

/// Data blocks for one file, each read by `index 'name'`.
class DataBlocks {
 public:
  void begin(const std::string& name, const std::string& columns);
  void row(const std::vector<double>& values);
  void break_line();  ///< the line of this block ends; the next row starts another
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// Runs `gnuplot --default-settings script` in `folder`. Throws InputError if it is missing or
/// fails.
void run(const std::filesystem::path& folder, const std::string& script);

}  // namespace glissade::gnuplot
