// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace glissade {

/// What the header of a record states: of a PEER file, or the comments of a text file. The text is
/// as printed: its meaning is for the caller to judge.
struct At2Header {
  std::size_t lines = 0;              ///< header lines, the one with NPTS included
  std::optional<std::uint64_t> npts;  ///< nothing: not a whole number that fits
  std::string dt_text;                ///< may be empty
  std::optional<double> dt_s;         ///< nothing: absent or no number
  std::size_t units_line = 0;         ///< 0: no units stated
  std::string units;                  ///< lower case: "g", "cm/s" ...
  std::string title;                  ///< the second line; empty: not of PEER's files
  std::string source;                 ///< the same; empty: not of PEER's NGA files
};

/// The header of a PEER file, if one of the first lines holds NPTS: `NPTS=  5590, DT=   .0100 SEC,`
/// or `7997 0.0050 NPTS, DT`.
std::optional<At2Header> find_at2_header(std::string_view text);

/// Takes what a line of a header states; true where it holds NPTS.
bool read_header_line(std::string_view line, std::size_t number, At2Header& header);

/// The step of a header with NPTS, or `wanted`, which may mend it.
double at2_step(const std::filesystem::path& file, const At2Header& header,
                const std::optional<double>& wanted);

/// InputError, with both counts, unless a header with NPTS states as many values as were found.
void check_at2_count(const std::filesystem::path& file, const At2Header& header, std::size_t found);

/// The units a header line states: "... IN UNITS OF CM/S", "ACCELERATION IN G", "The units are
/// (g)", "acceleration_g"; "" if none.
std::string units_in_header_line(std::string_view line);

}  // namespace glissade
