// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

namespace glissade {

/// The most that is believed of a header or of a report of a search.
inline constexpr double largest_magnitude = 10.0, longest_distance_km = 20'000.0,
                        fastest_vs30_mps = 10'000.0;

/// What a header states of a record besides its samples; what it does not is empty or 0.
struct RecordHeader {
  std::string event, station;
  std::string direction = {};  ///< "0", "UP", "HNE": degrees from north where it states them
  std::string unit = {};       ///< as written
  std::string event_id = {};   ///< of ESM
  double magnitude = 0.0;
  std::string magnitude_kind = {};  ///< "Mw", "ML", "MJMA", "M"
  double epicentral_km = 0.0;
  double vs30_mps = 0.0;
  std::optional<bool> is_processed = std::nullopt;
  std::string location = {};  ///< of a channel of a structure: "Roof, center", "FREEFIELD"
  std::string channel = {};   ///< its number at the station: "14"
};

}  // namespace glissade
