// SPDX-License-Identifier: GPL-3.0-or-later
#include "records/station_metadata.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <pugixml.hpp>

#include "records/formats/reading.hpp"
#include "records/record_units.hpp"

namespace glissade {
namespace {

/// "2019-07-06T03:19:47" of a date with parts of a second or a zone: dates then compare as texts.
std::string to_seconds(std::string_view date) { return std::string(date.substr(0, 19)); }

/// Dip is positive down (SEED 2.4, blockette 52).
std::string direction_of(const pugi::xml_node& channel) {
  constexpr double upright_deg = 45.0;
  const double dip_deg = channel.child("Dip").text().as_double(0.0);
  if (dip_deg <= -upright_deg) return "UP";
  if (dip_deg >= upright_deg) return "DOWN";
  const pugi::xml_node azimuth = channel.child("Azimuth");
  return azimuth ? shortest_decimal(azimuth.text().as_double()) : "";
}

}  // namespace

bool is_station_xml(const RecordText& file) {
  constexpr std::size_t looked_at = 1000;
  return lower_case(file.text.substr(0, looked_at)).find("<fdsnstationxml") != std::string::npos;
}

void StationMetadata::add(const RecordText& file) {
  constexpr std::size_t most_bytes = std::size_t{64} << 20, most_parts = 2'000'000,
                        most_channels = 100'000;
  const auto refuse_if = [&](bool is_large, const char* what) {
    if (is_large)
      refuse_record(file, fmt::format("holds more than {}", what),
                    "get the metadata of the stations of the records alone (level=channel)");
  };
  refuse_if(file.text.size() > most_bytes, "64 MiB of StationXML");
  const auto parts = std::ranges::count_if(file.text, [](char c) { return c == '<' || c == '='; });
  refuse_if(static_cast<std::size_t>(parts) > most_parts, "2 million elements and attributes");
  pugi::xml_document document;
  const pugi::xml_parse_result parsed =
      document.load_buffer(file.text.data(), file.text.size(), pugi::parse_default);
  if (!parsed)
    refuse_record(
        file.path.string(),
        fmt::format("is no whole XML: {} at byte {}", parsed.description(), parsed.offset),
        "get the file again");
  for (const pugi::xml_node& network : document.child("FDSNStationXML").children("Network")) {
    for (const pugi::xml_node& station : network.children("Station")) {
      for (const pugi::xml_node& channel : station.children("Channel")) {
        const pugi::xml_node stated = channel.child("Response").child("InstrumentSensitivity");
        refuse_if(channels_.size() == most_channels, "100,000 channels");
        Channel& read = channels_.emplace_back();
        read.id = fmt::format(
            "{}_{}_{}_{}", network.attribute("code").value(), station.attribute("code").value(),
            trimmed(channel.attribute("locationCode").value()), channel.attribute("code").value());
        read.start = to_seconds(channel.attribute("startDate").value());
        read.end = to_seconds(channel.attribute("endDate").as_string("9999"));
        read.input_unit = stated.child("InputUnits").child("Name").text().get();
        read.output_unit = lower_case(stated.child("OutputUnits").child("Name").text().get());
        read.sensitivity = stated.child("Value").text().as_double();
        read.gain.direction = direction_of(channel);
        read.gain.source = fmt::format("{} (sensitivity at {} Hz)", file.path.filename().string(),
                                       stated.child("Frequency").text().as_double());
      }
    }
  }
}

std::optional<ChannelGain> StationMetadata::find(const std::string& id,
                                                 std::string_view time) const {
  std::optional<ChannelGain> found;
  const std::string at = to_seconds(time);
  for (const Channel& channel : channels_) {
    if (channel.id != id || at < channel.start || at >= channel.end) continue;
    const HeaderUnit input = header_unit(channel.input_unit);
    const bool is_gain = input.kind == UnitKind::acceleration &&
                         header_unit(channel.output_unit).kind == UnitKind::counts;
    if (!is_gain || !(channel.sensitivity > 0.0))
      refuse_record(channel.gain.source,
                    fmt::format("channel {} has {:g} {} for 1 {}", id, channel.sensitivity,
                                in_quotes(channel.output_unit), in_quotes(channel.input_unit)),
                    "give the channel of an accelerometer, or counts_per_unit");
    ChannelGain gain = channel.gain;
    gain.counts_per_mps2 = channel.sensitivity / input.si;
    if (found && found->counts_per_mps2 != gain.counts_per_mps2)
      refuse_record(gain.source,
                    fmt::format("channel {} has two sensitivities at {}: {:g} and {:g} for 1 m/s2",
                                id, at, found->counts_per_mps2, gain.counts_per_mps2),
                    "state counts_per_unit");
    found = std::move(gain);
  }
  return found;
}

}  // namespace glissade
