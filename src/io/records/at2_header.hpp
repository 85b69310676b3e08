// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace glissade {

/// What the header of a record states: of a PEER file, or the lines above the values of a text
/// file. The text is as printed: its meaning is for the caller to judge.
struct At2Header {
  std::size_t lines = 0;  ///< of the header of a PEER file
  std::size_t npts_line = 0, dt_line = 0;
  std::optional<std::uint64_t> npts;  ///< nothing: not a whole number that fits
  std::string dt_text;                ///< may be empty
  std::optional<double> dt_s;         ///< nothing: absent or no number
  std::string other_dt_text;          ///< of a line above that states another step
  std::size_t units_line = 0;         ///< 0: no units stated
  std::string units;                  ///< lower case: "g", "cm/s" ...
  std::string title;                  ///< the second line; empty: not of PEER's files
  std::string source;                 ///< the same; empty: not of PEER's NGA files
};

/// The header of a PEER file, if one of the first lines holds NPTS: `NPTS=  5590, DT=   .0100 SEC,`
/// or `7997 0.0050 NPTS, DT`; lines "KEY: value" may follow it.
std::optional<At2Header> find_at2_header(std::string_view text);

/// Takes what a line of a header states: units, NPTS, and the step, by DT or another of its names
/// or by the sampling rate; true where it states one of them by name, and is no heading of columns.
bool read_header_line(std::string_view line, std::size_t number, At2Header& header);

/// The step of a header, or `wanted`, which may mend it. InputError where the header has no step,
/// or two.
double at2_step(const std::filesystem::path& file, const At2Header& header,
                const std::optional<double>& wanted);

/// InputError, with both counts, unless a header with NPTS states as many values as were found.
void check_at2_count(const std::filesystem::path& file, const At2Header& header, std::size_t found);

/// The units a header line states: "... IN UNITS OF CM/S", "ACCELERATION IN G", "The units are
/// (g)", "acceleration_g"; "" if none.
std::string units_in_header_line(std::string_view line);

}  // namespace glissade
