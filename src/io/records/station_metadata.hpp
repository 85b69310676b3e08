// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "records/formats/record_format.hpp"

namespace glissade {

/// What the metadata of a station state of a channel of an accelerometer.
struct ChannelGain {
  double counts_per_mps2 = 0.0;
  std::string direction;  ///< degrees from north, or "UP"
  std::string source;     ///< the file and the frequency of the sensitivity
};

/// Gains of recorders by FDSN StationXML 1, InstrumentSensitivity of each channel and epoch.
class StationMetadata {
 public:
  /// Takes the channels of a file. InputError where it is no XML, or larger than 64 MiB, two
  /// million elements and attributes or 100,000 channels.
  void add(const RecordText& file);
  bool empty() const { return channels_.empty(); }
  /// Of "NET_STA_LOC_CHA" at a time, "2019-07-06T03:19:47"; nothing where no file has it.
  /// InputError where it is no channel of counts for an acceleration, or its epochs overlap with
  /// other gains.
  std::optional<ChannelGain> find(const std::string& id, std::string_view time) const;

 private:
  struct Channel {
    std::string id, start, end, input_unit, output_unit;
    double sensitivity = 0.0;
    ChannelGain gain;
  };
  std::vector<Channel> channels_;
};

bool is_station_xml(const RecordText& file);

}  // namespace glissade
