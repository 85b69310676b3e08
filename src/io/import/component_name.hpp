// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace glissade {

/// What a header or a report states, as one short line that acts on nothing.
std::string plain_line(std::string_view text);

/// Which component of a record a word names.
struct ComponentDirection {
  bool is_vertical = false;
  bool is_down = false;               ///< "DWN": its positive values may be downwards
  std::optional<double> azimuth_deg;  ///< 0 to below 360, of a horizontal one that states it
  int order = 0;                      ///< 1 and 2 of the pairs without azimuth: H1 and H2, L and T
};

/// "67", "360 Deg", "UP", "N-S", "HNE", "H1", "U3" ...; nothing where the word names none.
std::optional<ComponentDirection> component_direction(std::string_view word);

/// The name of a file in two parts: "RSN763_LOMAP_GIL" and "067", "BOL" and "000", "a_TLM1" and
/// "NS"; with no direction where none is found. A name alone can only suggest one: it may as well
/// be the number of an earthquake or a date.
struct SplitName {
  std::string rest, direction;
};
/// @param stem of the file's name, without its extension
/// @param stated by the header, the report or the scheme of names; nothing: not stated
SplitName split_direction(std::string_view stem, const std::optional<ComponentDirection>& stated);

/// By the scheme of names of PEER's NGA data bases: "067" of "RSN763_LOMAP_GIL067"; "" of a name
/// that is not by it.
std::string peer_direction(std::string_view stem);
/// The code of a channel of SEED between points, as data centres name files of COSMOS and SAC:
/// "BNZ" of "us1000hyfh.BNZ.--.acc"; "" where there is none.
std::string channel_in_name(std::string_view stem);

/// Without the ending of a file's name; that of K-NET (AOM0170806140843.EW) names its direction.
std::string stem_of(const std::filesystem::path& file);

/// 763 of "RSN763_LOMAP_GIL067.AT2"; "" where the name has none.
std::string record_sequence_number(std::string_view file_name);

}  // namespace glissade
