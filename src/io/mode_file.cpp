// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/io/mode_file.hpp"

#include <fmt/format.h>

#include "glissade/core/error.hpp"
#include "text/csv_rows.hpp"

namespace glissade {

std::vector<Mode> read_modes(const std::filesystem::path& file) {
  std::vector<Mode> modes;
  const auto take = [&](const NumberRow& row) -> RowTrouble {
    const Mode mode{row.values[0], row.values[1], row.values[2]};
    if (!(mode.period_s > 0.0)) return {"the period is not above 0"};
    if (!modes.empty() && !(mode.period_s < modes.back().period_s))
      return {"periods must fall from row to row"};
    if (!(mode.mass_share > 0.0 && mode.mass_share <= 1.0))
      return {"the mass share is not above 0 and at most 1"};
    modes.push_back(mode);
    return {};
  };
  read_number_rows(file, {{{"period_s", "participation", "mass_share"}, take}});
  constexpr double rounding = 1e-3;  // of shares with a few digits
  if (mass_of(modes) > 1.0 + rounding)
    throw InputError(
        {file.string(),
         fmt::format("the mass shares are {:.4g} together, more than 1", mass_of(modes)),
         "give those of one axis, each as a fraction of the building's mass", ""});
  return modes;
}

}  // namespace glissade
