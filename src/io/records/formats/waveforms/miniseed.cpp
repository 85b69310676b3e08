// SPDX-License-Identifier: GPL-3.0-or-later
// miniSEED 2 by libmseed: records of one or more channels, which state no unit ("SEED Reference
// Manual", version 2.4, FDSN, 2012). The gain is stated, or that of the station's metadata.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>

#ifdef GLISSADE_MINISEED
#include <libmseed.h>
#endif

#include "records/formats/reading.hpp"
#include "records/station_metadata.hpp"

namespace glissade {
namespace {

bool is_miniseed(const RecordText& file) {
  constexpr std::size_t fixed_header = 48;
  const std::string_view bytes = file.text;
  if (bytes.size() < fixed_header) return false;
  for (std::size_t i = 0; i < 6; ++i)
    if (bytes[i] != ' ' && (bytes[i] < '0' || bytes[i] > '9')) return false;
  return std::string_view("DRQM").find(bytes[6]) != std::string_view::npos &&
         (bytes[7] == ' ' || bytes[7] == '\0') && bytes.find('\0') != std::string::npos;
}

#ifdef GLISSADE_MINISEED

struct FreeMseed {
  void operator()(MSRecord* record) const { msr_free(&record); }
};
using MseedRecord = std::unique_ptr<MSRecord, FreeMseed>;

/// A channel as its records continue one another.
struct MseedChannel {
  std::string name;
  double rate_hz = 0.0;
  hptime_t start = 0, end = 0;  ///< of its first and last sample
  bool is_counts = false;
  std::vector<double> values;
};

/// @param bytes of the file, which libmseed may write to while it decodes them
MseedRecord parse_mseed(const RecordText& file, std::string& bytes, std::size_t at) {
  const std::size_t left = std::min<std::size_t>(bytes.size() - at, MAXRECLEN);
  MSRecord* raw = nullptr;
  constexpr int unknown_length = 0, with_data = 1, quiet = 0;
  const int code =
      msr_parse(bytes.data() + at, static_cast<int>(left), &raw, unknown_length, with_data, quiet);
  MseedRecord record(raw);
  if (code == MS_NOERROR && record && record->reclen >= MINRECLEN) return record;
  refuse_record(file, fmt::format("the miniSEED record at byte {} is damaged", at),
                "the file is cut short or no miniSEED 2: get it again");
}

std::string time_text(hptime_t time) {
  std::array<char, 40> text{};
  return ms_hptime2isotimestr(time, text.data(), 1) == nullptr ? "?" : text.data();
}

void check_continues(const RecordText& file, const MseedChannel& channel, MSRecord& record) {
  if (channel.values.empty()) return;
  const double step = HPTMODULUS / channel.rate_hz;
  const auto apart = static_cast<double>(record.starttime - channel.end);
  if (record.samprate == channel.rate_hz && std::abs(apart - step) <= 0.5 * step) return;
  refuse_record(file,
                fmt::format("channel {} has a gap, an overlap or another rate: from {} to {}",
                            channel.name, time_text(channel.end), time_text(record.starttime)),
                "cut out the continuous part that holds the motion");
}

void append_mseed(const RecordText& file, MseedChannel& channel, const MSRecord& record) {
  const auto add = [&](const auto* values) {
    for (std::int64_t i = 0; i < record.numsamples; ++i)
      add_number(file, static_cast<double>(values[i]), channel.values);
  };
  switch (record.sampletype) {
    case 'i':
      channel.is_counts = true;
      return add(static_cast<const std::int32_t*>(record.datasamples));
    case 'f':
      return add(static_cast<const float*>(record.datasamples));
    case 'd':
      return add(static_cast<const double*>(record.datasamples));
    default:
      refuse_record(file, "channel " + channel.name + " holds no numbers",
                    "give the channel of an accelerometer");
  }
}

std::vector<MseedChannel> mseed_channels(const RecordText& file) {
  // Its messages would go to standard error.
  const auto silent = [](char*) {};
  ms_loginit(silent, nullptr, silent, nullptr);
  std::string bytes(file.text);
  std::vector<MseedChannel> channels;
  std::size_t samples = 0;
  for (std::size_t at = 0; at + MINRECLEN <= bytes.size();) {
    const MseedRecord record = parse_mseed(file, bytes, at);
    at += static_cast<std::size_t>(record->reclen);
    if (record->numsamples <= 0 || record->datasamples == nullptr) continue;
    std::array<char, 50> name{};
    msr_srcname(record.get(), name.data(), 0);
    auto channel = std::ranges::find(channels, name.data(), &MseedChannel::name);
    if (channel == channels.end()) {
      channels.push_back({name.data(), record->samprate, record->starttime, 0, false, {}});
      channel = channels.end() - 1;
    }
    check_continues(file, *channel, *record);
    samples += static_cast<std::size_t>(record->numsamples);
    if (samples > most_samples)
      refuse_record(file, fmt::format("has more than {} samples in all channels", most_samples),
                    "give a file for each channel");
    append_mseed(file, *channel, *record);
    channel->end = msr_endtime(record.get());
  }
  return channels;
}

std::vector<FileComponent> read_miniseed(const RecordText& file, const RecordFileOptions& options) {
  std::vector<FileComponent> components;
  for (MseedChannel& channel : mseed_channels(file)) {
    if (!channel.is_counts) ask_for_unit(file, "miniSEED", options);
    std::optional<ChannelGain> gain;
    RecordFileOptions stated = options;
    if (channel.is_counts && !options.counts_per_unit && options.stations != nullptr)
      gain = options.stations->find(channel.name, time_text(channel.start));
    if (gain) {
      stated.units = AccelerationUnits::mps2;
      stated.counts_per_unit = gain->counts_per_mps2;
    }
    const std::string code = channel.name.substr(channel.name.rfind('_') + 1);
    if (!gain) refuse_seismometer(file, code);
    const double unit_mps2 = stated_unit(file, channel.is_counts ? "counts" : "", 0, stated);
    const double step_s = channel.rate_hz > 0.0 ? to_twelve_digits(1.0 / channel.rate_hz) : 0.0;
    const double dt_s = stated_step(file.path.string(), shortest_decimal(step_s), step_s, options);
    std::vector<double> samples;
    for (const double value : channel.values) add_value(file, value, unit_mps2, samples);
    const std::string direction =
        gain && !gain->direction.empty() ? gain->direction : plain_direction(code);
    RecordHeader header{"", channel.name.substr(0, channel.name.rfind('_')), direction,
                        channel.is_counts ? "counts" : ""};
    if (channel.is_counts) header.is_processed = false;
    FileComponent component =
        file_component(file, channel.name, dt_s, std::move(samples), std::move(header));
    component.direction = code;
    if (gain) component.counts_per_mps2 = gain->counts_per_mps2;
    if (channel.is_counts)
      component.record.notes.emplace_back(
          "counts of the recorder by " +
          (gain ? "the gain of " + gain->source : std::string("the stated gain")) +
          ": not corrected, their offset is in them");
    components.push_back(std::move(component));
  }
  if (components.empty()) refuse_record(file, "is miniSEED without samples", "get the file again");
  return components;
}

#else

std::vector<FileComponent> read_miniseed(const RecordText& file, const RecordFileOptions&) {
  refuse_record(file, "is miniSEED, which this glissade was built without",
                "install libmseed-dev and build it again, or write it as text (ObsPy: "
                "stream.write(..., format=\"TSPAIR\"))");
}

#endif

}  // namespace

const RecordFormat miniseed_format{"miniSEED", is_miniseed, read_miniseed, true};

}  // namespace glissade
