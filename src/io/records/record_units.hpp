// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "glissade/io/record_file.hpp"

namespace glissade {

enum class UnitKind {
  none,
  acceleration,
  velocity,
  displacement,
  time,
  frequency,
  counts,
  label,
  unknown
};

/// A unit as a header writes it.
struct HeaderUnit {
  UnitKind kind = UnitKind::none;
  double si = 1.0;  ///< m/s2, m/s, m or s of one
};

/// "cm/s/s", "M/SEC**2", "m/s^2", "gal", "g's", "G/10", "ms", "Unitless" ...
HeaderUnit header_unit(std::string_view text);

/// A unit and the line that states it; 0: none does.
struct StatedUnit {
  std::string text;
  std::size_t line = 0;
};

/// m/s2 of a record's unit: that of its header, with which the options must agree, else that of the
/// options, by counts_per_unit where they give it. Throws InputError where neither states it, and
/// for velocities and displacements.
double unit_of_record_mps2(const std::filesystem::path& file, const StatedUnit& stated,
                           const RecordFileOptions& options);

}  // namespace glissade
