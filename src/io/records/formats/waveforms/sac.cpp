// SPDX-License-Identifier: GPL-3.0-or-later
// SAC, binary, of either byte order: 70 floats, 40 integers, 192 characters, then floats; it states
// no unit ("SAC Data File Format", SAC manual, IRIS, 2012).
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "records/formats/reading.hpp"

namespace glissade {
namespace {

constexpr std::size_t sac_header_bytes = 632, sac_text_at = 440;
// Words of the header.
constexpr std::size_t sac_delta = 0, sac_magnitude = 39, sac_distance = 50, sac_azimuth = 57,
                      sac_inclination = 58, sac_version = 76, sac_npts = 79, sac_file_type = 85,
                      sac_quantity = 86, sac_is_even = 105;
constexpr std::int32_t sac_this_version = 6, sac_time_series = 1, sac_displacement = 6,
                       sac_velocity = 7, sac_acceleration = 8, sac_volts = 50;
constexpr float sac_not_stated = -12345.0F;

std::uint32_t sac_word(std::string_view bytes, std::size_t word, bool swapped) {
  std::array<char, 4> four{};
  std::memcpy(four.data(), bytes.data() + 4 * word, four.size());
  if (swapped != (std::endian::native == std::endian::big)) std::ranges::reverse(four);
  return std::bit_cast<std::uint32_t>(four);
}
std::int32_t sac_integer(std::string_view bytes, std::size_t word, bool big) {
  return std::bit_cast<std::int32_t>(sac_word(bytes, word, big));
}
float sac_float(std::string_view bytes, std::size_t word, bool big) {
  return std::bit_cast<float>(sac_word(bytes, word, big));
}

/// Whether the file is big-endian; nothing: no SAC file.
std::optional<bool> sac_order(std::string_view bytes) {
  if (bytes.size() < sac_header_bytes) return std::nullopt;
  for (const bool big : {false, true})
    if (sac_integer(bytes, sac_version, big) == sac_this_version &&
        sac_integer(bytes, sac_file_type, big) >= 1 && sac_integer(bytes, sac_file_type, big) <= 60)
      return big;
  return std::nullopt;
}

bool is_sac(const RecordText& file) { return sac_order(file.text).has_value(); }

/// Names of eight characters, the first of sixteen: 0 the station, 20 the channel, 21 the network.
std::string sac_name(std::string_view bytes, std::size_t eighth) {
  const std::string_view field = bytes.substr(sac_text_at + 8 * eighth, 8);
  const std::string_view name = trimmed(field.substr(0, field.find('\0')));
  return name.starts_with("-12345") ? "" : std::string(name);
}

/// The event, of sixteen characters.
std::string sac_long_name(std::string_view bytes) {
  const std::string first = sac_name(bytes, 1);
  return first.size() < 8 ? first : first + sac_name(bytes, 2);
}

/// The decimal that was meant: 0.02 of the float 0.0199999996.
double sac_decimal(float value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return fortran_number({text.data(), static_cast<std::size_t>(end - text.data())}).value_or(0.0);
}

/// What the header says of the values.
std::string sac_unit(const RecordText& file, std::int32_t quantity,
                     const RecordFileOptions& options) {
  if (quantity == sac_velocity || quantity == sac_displacement)
    refuse_record(file,
                  std::string("is a SAC file of ") +
                      (quantity == sac_velocity ? "velocities" : "displacements"),
                  "give the file of accelerations");
  if (quantity == sac_volts && !options.counts_per_unit) return "volts";
  return "";
}

/// By CMPINC, degrees from up, and CMPAZ; where they are not stated, by the channel.
std::string sac_direction(const RecordText& file, bool big, const std::string& channel) {
  constexpr float tolerance_deg = 5.0F;
  const float azimuth = sac_float(file.text, sac_azimuth, big),
              inclination = sac_float(file.text, sac_inclination, big);
  const std::string by_channel = plain_direction(channel);
  if (inclination == sac_not_stated) return by_channel;
  const auto is = [&](float degrees) { return std::abs(inclination - degrees) <= tolerance_deg; };
  const auto seed = seed_channel(channel);
  const bool is_vertical = is(0.0F) || is(180.0F),
             contradicts = is_vertical
                               ? seed && (seed->orientation == 'N' || seed->orientation == 'E')
                               : by_channel == "UP";
  if ((!is_vertical && !is(90.0F)) || contradicts)
    refuse_record(file,
                  fmt::format("CMPINC = {:g} degrees from up, of channel {}: neither vertical nor "
                              "horizontal",
                              inclination, in_quotes(channel)),
                  "correct CMPINC in its header: 0 up, 90 horizontal (SAC: chnhdr)");
  if (is_vertical) return is(0.0F) ? "UP" : "DOWN";
  return azimuth == sac_not_stated ? by_channel : shortest_decimal(sac_decimal(azimuth));
}

std::vector<FileComponent> read_sac(const RecordText& file, const RecordFileOptions& options) {
  std::string_view bytes = file.text;
  const bool big = *sac_order(bytes);
  const std::string where = file.path.string();
  if (sac_integer(bytes, sac_file_type, big) != sac_time_series ||
      sac_integer(bytes, sac_is_even, big) != 1)
    refuse_record(where, "is a SAC file of a spectrum, or of uneven times",
                  "interpolate it (SAC: interpolate) and write a time series");
  const std::int32_t quantity = sac_integer(bytes, sac_quantity, big);
  const std::string channel = sac_name(bytes, 20);
  const std::string unit = sac_unit(file, quantity, options);
  if (quantity != sac_acceleration) refuse_seismometer(file, channel);
  if (unit.empty()) ask_for_unit(file, "SAC", options);
  const double unit_mps2 = stated_unit(file, unit, 0, options);
  const std::int32_t stated = sac_integer(bytes, sac_npts, big);
  const std::size_t held = (bytes.size() - sac_header_bytes) / sizeof(float);
  if (stated < 1 || static_cast<std::size_t>(stated) != held)
    refuse_record(where,
                  fmt::format("its header states {} values, the file contains {}", stated, held),
                  "the file is cut short or damaged: get it again");
  const double step_s = sac_decimal(sac_float(bytes, sac_delta, big));
  const double dt_s = stated_step(where, shortest_decimal(step_s), step_s, options);
  std::vector<double> samples;
  for (std::size_t i = 0; i < held; ++i)
    add_value(file, sac_float(bytes, sac_header_bytes / sizeof(float) + i, big), unit_mps2,
              samples);
  RecordHeader header{sac_long_name(bytes), sac_name(bytes, 21) + "." + sac_name(bytes, 0),
                      sac_direction(file, big, channel), unit};
  state_magnitude(header, fmt::format("M {:.4g}", sac_float(bytes, sac_magnitude, big)),
                  {{"M", "M"}});
  if (const float km = sac_float(bytes, sac_distance, big); km > 0.0F && km < 1e5F)
    header.epicentral_km = km;
  return {file_component(file, channel, dt_s, std::move(samples), std::move(header))};
}

}  // namespace

const RecordFormat sac_format{"SAC", is_sac, read_sac, true};

}  // namespace glissade
