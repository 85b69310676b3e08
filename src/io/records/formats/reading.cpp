// SPDX-License-Identifier: GPL-3.0-or-later
#include "records/formats/reading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numbers>

#include "glissade/motion/improbable.hpp"

namespace glissade {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Where a number that Fortran wrote at the beginning of `text` ends: an exponent has two digits
/// where more follow it.
std::size_t end_of_number(std::string_view text) {
  std::size_t at = 0;
  const auto skip_digits = [&] {
    while (at < text.size() && is_digit(text[at])) ++at;
  };
  if (at < text.size() && (text[at] == '-' || text[at] == '+')) ++at;
  skip_digits();
  if (at < text.size() && text[at] == '.') ++at;
  skip_digits();
  if (at >= text.size() || std::string_view("eEdD").find(text[at]) == std::string_view::npos)
    return at;
  const std::size_t mantissa = at++;
  if (at < text.size() && (text[at] == '-' || text[at] == '+')) ++at;
  const std::size_t exponent = at;
  skip_digits();
  return at == exponent ? mantissa : std::min(at, exponent + 2);
}

}  // namespace

std::string RecordText::at(std::size_t line) const {
  return line == 0 ? path.string() : place(path, line);
}

std::string_view RecordText::first_line() const {
  constexpr std::size_t longest = 1000;
  LineReader lines(text.substr(0, longest));
  return lines.next() ? lines.line() : std::string_view();
}

void refuse_record(const std::string& where, const std::string& what,
                   const std::string& suggestion) {
  throw InputError({where, what, suggestion, ""});
}

void refuse_record(const RecordText& file, const std::string& what, const std::string& suggestion) {
  refuse_record(file.path.string(), what, suggestion);
}

void refuse_spectrum(const std::string& where, const std::string& column) {
  refuse_record(where,
                fmt::format("the column {} is a period or a frequency, no time: a spectrum (or a "
                            "table of modes), and no record",
                            in_quotes(column)),
                "give accelerations by time: Time (s), a (g)");
}

std::optional<double> fortran_number(std::string_view text) {
  text = trimmed(text);
  const std::size_t d = text.find_first_of("dD");
  if (d == std::string_view::npos || text.size() > 40) return parse_number(text);
  std::string with_e(text);
  with_e[d] = 'e';
  return parse_number(with_e);
}

std::vector<std::string_view> touching_numbers(std::string_view token) {
  constexpr std::size_t longest_line = 1000;  // of Fortran
  if (token.size() > longest_line || fortran_number(token)) return {token};
  std::vector<std::string_view> parts;
  for (std::string_view rest = token; !rest.empty();) {
    const std::size_t end = end_of_number(rest);
    const std::string_view part = rest.substr(0, end);
    if (part.find('.') == part.npos || !fortran_number(part)) return {token};
    parts.push_back(rest.substr(0, end));
    rest.remove_prefix(end);
  }
  return parts;
}

std::vector<std::string_view> fixed_fields(std::string_view line, std::size_t width) {
  std::vector<std::string_view> parts;
  const std::size_t blank = line.find_last_not_of(" \t\r");
  line = line.substr(0, blank == std::string_view::npos ? 0 : blank + 1);
  for (std::size_t at = 0; at < line.size() && parts.size() < most_fields; at += width)
    parts.push_back(trimmed(line.substr(at, parts.size() + 1 < most_fields ? width : line.npos)));
  return parts;
}

std::size_t field_width(std::string_view line) {
  const std::size_t open = line.rfind('(');
  if (open == std::string_view::npos) return 0;
  std::size_t at = open + 1;
  while (at < line.size() && is_digit(line[at])) ++at;
  if (at >= line.size() || std::string_view("eEfFgGiI").find(line[at]) == std::string_view::npos)
    return 0;
  std::size_t width = 0;
  constexpr std::size_t widest = 40;
  const char* begin = line.data() + at + 1;
  const auto [end, error] = std::from_chars(begin, line.data() + line.size(), width);
  return error == std::errc() && end != begin && width <= widest ? width : 0;
}

double parse_finite(const RecordText& file, std::size_t line, std::string_view token,
                    const char* what) {
  const std::optional<double> value = fortran_number(token);
  const std::string named = std::string(what) + " " + in_quotes(token);
  if (!value) refuse_record(file.at(line), named + " is not a number", what_is_read);
  if (!std::isfinite(*value))
    refuse_record(file.at(line), named + " is not finite",
                  "repair the record: every sample must be a finite number");
  return *value;
}

void add_number(const RecordText& file, double value, std::vector<double>& values) {
  if (values.size() == most_samples)
    refuse_record(file, fmt::format("has more than {} samples", most_samples),
                  "give the strong part of the record");
  values.push_back(value);
}

void add_component(const RecordText& file, FileComponent component,
                   std::vector<FileComponent>& components) {
  std::size_t samples = component.record.acceleration_mps2.size();
  for (const FileComponent& other : components) samples += other.record.acceleration_mps2.size();
  if (samples > most_samples)
    refuse_record(file, fmt::format("has more than {} samples in all components", most_samples),
                  "give a file for each component");
  components.push_back(std::move(component));
}

void add_sample(const RecordText& file, std::size_t line, std::string_view token, double unit_mps2,
                std::vector<double>& samples_mps2) {
  const double sample_mps2 = unit_mps2 * parse_finite(file, line, token, "the value");
  if (!(std::abs(sample_mps2) <= most_acceleration_mps2))
    refuse_record(file.at(line), "the value " + in_quotes(token) + " is more than 100,000 g",
                  "repair the record, or correct its units");
  add_number(file, sample_mps2, samples_mps2);
}

void add_value(const RecordText& file, double value, double unit_mps2,
               std::vector<double>& samples_mps2) {
  if (!(std::abs(value * unit_mps2) <= most_acceleration_mps2))
    refuse_record(file,
                  fmt::format("value {}, {:g}, is not finite, or more than 100,000 g",
                              samples_mps2.size() + 1, value),
                  "repair the record, or correct its units");
  add_number(file, value * unit_mps2, samples_mps2);
}

std::vector<double> read_block(const RecordText& file, LineReader& lines,
                               const SampleBlock& block) {
  std::vector<double> samples;
  const std::size_t begin = lines.number();
  while (samples.size() < block.count) {
    if (!lines.next())
      refuse_record(
          file.at(begin),
          fmt::format("states {} values, and the file ends after {}", block.count, samples.size()),
          cut_short);
    const auto add = [&](std::string_view token) {
      if (samples.size() == block.count)
        refuse_record(
            file.at(lines.number()),
            fmt::format("has more than the {} values that line {} states", block.count, begin),
            "the file is damaged: get it again");
      add_sample(file, lines.number(), token, block.unit_mps2, samples);
    };
    if (block.width > 0) {
      for (const std::string_view field : fixed_fields(lines.line(), block.width)) add(field);
    } else {
      for (FieldReader token(lines.line()); token.next();)
        for (const std::string_view number : touching_numbers(token.field())) add(number);
    }
  }
  return samples;
}

std::vector<double> read_rest(const RecordText& file, LineReader& lines, double unit_mps2) {
  std::vector<double> samples;
  while (lines.next()) {
    for (FieldReader token(lines.line()); token.next();)
      for (const std::string_view number : touching_numbers(token.field()))
        add_sample(file, lines.number(), number, unit_mps2, samples);
  }
  return samples;
}

void add_pairs(const RecordText& file, std::size_t line, const std::vector<std::string_view>& row,
               double unit_mps2, TimedSamples& pairs) {
  for (std::size_t i = 0; i + 1 < row.size(); i += 2) {
    pairs.time.add(parse_finite(file, line, row[i], "the time"), row[i], line);
    add_sample(file, line, row[i + 1], unit_mps2, pairs.samples_mps2);
  }
}

double step_of_rows(const RecordText& file, const TimedSamples& rows, const At2Header& stated,
                    const RecordFileOptions& options, std::vector<std::string>& notes) {
  const std::optional<double> wanted =
      stated.dt_text.empty() ? options.dt_s
                             : std::optional(at2_step(file.path, stated, options.dt_s));
  const std::vector<double>& t = rows.time.times_s;
  const auto is_clock = [&] {
    try {
      step_of(file.path, rows.time, std::nullopt);
      return true;
    } catch (const InputError&) {
      return false;
    }
  };
  try {
    const double dt_s = step_of(file.path, rows.time, wanted);
    const double printed_s = t.size() > 1 ? t[1] - t[0] : dt_s;
    if (std::abs(printed_s - dt_s) > 1e-6 * dt_s)
      notes.push_back(
          fmt::format("the step is {:.7g} s, that of its first and last time: between printed "
                      "times it is {:.4g}",
                      dt_s, printed_s));
    return dt_s;
  } catch (const InputError& error) {
    if (std::ranges::any_of(rows.samples_mps2, [](double a) { return a < 0.0; }) || is_clock())
      throw;
    Problem spectrum = error.problems().front();
    spectrum.what += "; and no value is below 0: a spectrum, and no record";
    spectrum.suggestion = "give accelerations by evenly spaced times";
    throw InputError(spectrum);
  }
}

double digitised_step_s(const RecordText& file, const TimedSamples& pairs,
                        const RecordFileOptions& options) {
  try {
    return step_of(file.path, pairs.time, options.dt_s);
  } catch (const InputError& error) {
    Problem uneven = error.problems().front();
    uneven.what = "is an uncorrected accelerogram as its film was digitised: " + uneven.what;
    uneven.suggestion = "give the corrected record (Volume II), or resample this one";
    throw InputError(uneven);
  }
}

void add_row(const RecordText& file, std::size_t line, std::span<const std::string_view> row,
             double unit_mps2, std::vector<std::vector<double>>& components) {
  if (row.size() != components.size())
    refuse_record(file.at(line),
                  fmt::format("has {} columns of samples, {} components are stated", row.size(),
                              components.size()),
                  cut_short);
  for (std::size_t i = 0; i < row.size(); ++i)
    add_sample(file, line, row[i], unit_mps2, components[i]);
}

std::optional<HeaderLine> line_with_colon(const LineReader& lines) {
  const std::string_view line = lines.line();
  constexpr std::size_t longest = 10'000;
  const std::size_t colon = line.find(':');
  if (colon == std::string_view::npos || line.size() > longest) return std::nullopt;
  return HeaderLine{std::string(trimmed(line.substr(0, colon))),
                    std::string(trimmed(line.substr(colon + 1))), lines.number()};
}

HeaderLine line_beginning(const std::vector<HeaderLine>& header, std::string_view key) {
  const auto found = std::ranges::find_if(header, [&](const HeaderLine& line) {
    return line.key.starts_with(key) && !line.value.empty();
  });
  return found != header.end() ? *found : HeaderLine{std::string(key), "", 0};
}

HeaderLines HeaderLines::with_colons(LineReader& lines) {
  HeaderLines header;
  constexpr std::size_t most_lines = 200;
  for (LineReader ahead = lines; header.lines_.size() < most_lines && ahead.next();) {
    auto line = line_with_colon(ahead);
    if (!line) break;
    header.lines_.push_back(*std::move(line));
    lines = ahead;
  }
  return header;
}

HeaderLines HeaderLines::in_columns(LineReader& lines, std::size_t width, std::size_t count) {
  HeaderLines header;
  while (header.lines_.size() < count && lines.next()) {
    const std::string_view line = lines.line();
    const std::size_t comma = line.find(','), end = std::min(width, comma);
    std::string_view value = line.substr(std::min(end + (comma < width ? 1 : 0), line.size()));
    while (comma < width && value.ends_with(',')) value.remove_suffix(1);
    header.lines_.push_back(
        {std::string(trimmed(line.substr(0, end))), std::string(trimmed(value)), lines.number()});
  }
  return header;
}

const HeaderLine* HeaderLines::find(std::string_view key) const {
  const auto found = std::ranges::find(lines_, key, &HeaderLine::key);
  return found == lines_.end() || found->value.empty() ? nullptr : &*found;
}

std::string HeaderLines::value(std::string_view key) const {
  const HeaderLine* found = find(key);
  return found == nullptr ? "" : found->value;
}

const HeaderLine& HeaderLines::required(const RecordText& file, std::string_view key) const {
  const HeaderLine* found = find(key);
  if (found == nullptr)
    refuse_record(file, "its header does not state " + in_quotes(key),
                  "the file is cut short or was edited: get it again");
  return *found;
}

std::size_t stated_count(const RecordText& file, const HeaderLine& stated) {
  const auto count = first_number(stated.value);
  if (!count || count->value < 1.0 || count->value > static_cast<double>(most_samples) ||
      std::round(count->value) != count->value)
    refuse_record(
        file.at(stated.line),
        fmt::format("{} is {}, no number of samples", stated.key, in_quotes(stated.value)),
        "get the file again");
  return static_cast<std::size_t>(count->value);
}

void check_stated_count(const std::string& where, std::size_t stated, std::size_t found) {
  if (stated == found) return;
  refuse_record(where, fmt::format("states {} values, the file contains {}", stated, found),
                "the file is cut short or its header is wrong: get it again");
}

void check_stated_count(const RecordText& file, const HeaderLine& stated, std::size_t found) {
  check_stated_count(file.at(stated.line), stated_count(file, stated), found);
}

double stated_step(const std::string& where, const std::string& text, std::optional<double> dt_s,
                   const RecordFileOptions& options) {
  return agreed_step(where, text, dt_s, options.dt_s);
}

double stated_step(const RecordText& file, const HeaderLine& stated,
                   const RecordFileOptions& options) {
  return stated_step(file.at(stated.line), stated.value, fortran_number(stated.value), options);
}

void check_duration(const std::string& where, double stated_s, double dt_s, std::size_t samples,
                    double tolerance_s) {
  const double found_s = dt_s * static_cast<double>(samples);
  if (std::abs(found_s - stated_s) <= tolerance_s + 0.02 * found_s) return;
  refuse_record(where,
                fmt::format("states {:g} s, and {} samples of {:g} s are {:g} s", stated_s, samples,
                            dt_s, found_s),
                "its step or its duration is wrong: get the file again");
}

double stated_unit(const RecordText& file, const std::string& text, std::size_t line,
                   const RecordFileOptions& options) {
  return unit_of_record_mps2(file.path, {text, line}, options);
}

double stated_unit(const RecordText& file, const StatedUnit& unit, bool has_step,
                   const RecordFileOptions& options) {
  if (unit.text.empty() && !options.units && !options.units_if_not_stated && !has_step)
    refuse_record(
        file, "states neither the units of its accelerations nor the time step",
        "give units as g, m/s2 or cm/s2, and the step with dt_s; or first lines \"# units: "
        "g\" and \"# DT = 0.01\"");
  return stated_unit(file, unit.text, unit.line, options);
}

std::optional<FoundNumber> first_number(std::string_view text, std::size_t from) {
  constexpr std::string_view parts = "0123456789.+-";
  for (std::size_t at = text.find_first_of(parts, from); at < text.size();
       at = text.find_first_of(parts, at + 1)) {
    const std::size_t end = at + end_of_number(text.substr(at));
    if (const auto value = fortran_number(text.substr(at, end - at)))
      return FoundNumber{*value, end};
  }
  return std::nullopt;
}

std::string first_word(std::string_view text) {
  const auto words = fields(text);
  return words.empty() ? "" : std::string(words.front());
}

std::string single_blanks(std::string_view text) {
  constexpr std::string_view blanks = " \t\r";
  std::string plain;
  for (const char c : trimmed(text)) {
    const bool is_blank = blanks.find(c) != std::string_view::npos;
    if (!is_blank)
      plain += c;
    else if (!plain.empty() && plain.back() != ' ')
      plain += ' ';
  }
  return plain;
}

void ask_for_unit(const RecordText& file, const char* format, const RecordFileOptions& options) {
  if (options.units || options.units_if_not_stated) return;
  refuse_record(file, std::string(format) + " files do not state their unit",
                "give units as g, m/s2 or cm/s2");
}

std::string plain_direction(std::string_view direction) {
  const std::string lower = lower_case(trimmed(direction));
  const auto is_one_of = [&](std::initializer_list<std::string_view> names) {
    return std::ranges::find(names, lower) != names.end();
  };
  const auto seed = seed_channel(lower);
  const char toward = seed ? seed->orientation : '\0';
  if (toward == 'N' || is_one_of({"n-s", "ns", "n", "north"})) return "0";
  if (toward == 'E' || is_one_of({"e-w", "ew", "we", "w-e", "e", "east"})) return "90";
  if (toward == 'Z' || is_one_of({"u-d", "ud", "up", "u", "z", "v", "vertical", "vert"}))
    return "UP";
  const auto angle = first_number(lower);
  const bool north = lower.starts_with('n'), south = lower.starts_with('s'),
             west = lower.ends_with('w'), east = lower.ends_with('e');
  if (!angle || !(north || south) || !(east || west))
    return angle && lower.ends_with("deg") ? shortest_decimal(angle->value)
                                           : std::string(trimmed(direction));
  const double a = angle->value;
  return shortest_decimal(south ? (west ? 180.0 + a : 180.0 - a) : (west ? 360.0 - a : a));
}

std::optional<SeedChannel> seed_channel(std::string_view code) {
  std::string letters(code.substr(0, 5));
  for (char& c : letters) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  const bool has_location = code.size() == 5 && is_digit(code[3]) && is_digit(code[4]);
  if (code.size() != 3 && !has_location) return std::nullopt;
  const auto is_in = [](char c, std::string_view set) { return set.find(c) != set.npos; };
  const bool is_channel =
      is_in(letters[0], "FGDCESHBL") && is_in(letters[1], "NLGHP") && is_in(letters[2], "NEZ123");
  return is_channel ? std::optional(SeedChannel{letters[1], letters[2]}) : std::nullopt;
}

void refuse_seismometer(const RecordText& file, std::string_view channel) {
  const auto seed = seed_channel(channel);
  if (!seed || (seed->instrument != 'H' && seed->instrument != 'P')) return;
  refuse_record(file,
                fmt::format("channel {} is that of a seismometer, and its file does not state that "
                            "it holds accelerations",
                            in_quotes(channel)),
                "give the channel of an accelerometer (HN.), or state it in the file (SAC: IDEP = "
                "IACC; a table: the unit in its heading): units alone does not");
}

ChannelLine channel_line(std::string_view line) {
  constexpr std::size_t longest = 500;
  line = line.substr(0, longest);
  const std::string lower = lower_case(line);
  const auto behind = [&](std::string_view key) {
    const std::size_t at = lower.find(key);
    return at == std::string::npos ? std::string_view() : line.substr(at + key.size());
  };
  ChannelLine channel;
  channel.location = single_blanks(behind("location:"));
  const std::string_view own =
      trimmed(line.substr(0, std::min({lower.find('('), lower.find("location:"), lower.size()})));
  const std::size_t colon = own.rfind(':');
  const bool is_numbered = colon != std::string_view::npos;
  channel.name = single_blanks(own);
  channel.direction = trimmed(own.substr(is_numbered ? colon + 1 : 0));
  for (const std::string_view text : {behind("(sta chn:"), own.substr(0, is_numbered ? colon : 0)})
    if (const auto number = first_number(text); number && channel.number.empty())
      channel.number = shortest_decimal(number->value);
  return channel;
}

void take_channel(RecordHeader& header, const ChannelLine& channel) {
  header.direction = plain_direction(channel.direction);
  header.location = channel.location;
  header.channel = channel.number;
}

void state_magnitude(RecordHeader& header, std::string_view line,
                     std::initializer_list<MagnitudeName> names) {
  const std::string lower = lower_case(line);
  for (const auto& [name, kind] : names) {
    const std::size_t at = lower.find(lower_case(name));
    if (at == std::string::npos) continue;
    const std::size_t begin = lower.find_first_not_of(" =:", at + name.size());
    const auto found = begin == std::string::npos ? std::nullopt : first_number(lower, begin);
    constexpr double most = 10.0;
    const bool follows = found && lower[begin] >= '0' && lower[begin] <= '9';
    if (!follows || !(found->value > 0.0 && found->value <= most)) continue;
    header.magnitude = found->value;
    header.magnitude_kind = kind;
    return;
  }
}

double epicentral_km(std::optional<double> event_latitude_deg,
                     std::optional<double> event_longitude_deg,
                     std::optional<double> station_latitude_deg,
                     std::optional<double> station_longitude_deg) {
  constexpr double earth_radius_km = 6371.0, degree = std::numbers::pi / 180.0;
  const auto is_within = [](const std::optional<double>& angle_deg, double most_deg) {
    return angle_deg && std::abs(*angle_deg) <= most_deg;
  };
  if (!is_within(event_latitude_deg, 90.0) || !is_within(station_latitude_deg, 90.0) ||
      !is_within(event_longitude_deg, 360.0) || !is_within(station_longitude_deg, 360.0))
    return 0.0;
  const double one = degree * *event_latitude_deg, other = degree * *station_latitude_deg;
  const double north = std::sin(0.5 * (one - other)),
               east = std::sin(0.5 * degree * (*event_longitude_deg - *station_longitude_deg));
  const double square = north * north + std::cos(one) * std::cos(other) * east * east;
  const double distance_km = 2.0 * earth_radius_km * std::asin(std::sqrt(std::min(square, 1.0)));
  return std::round(100.0 * distance_km) / 100.0;
}

FileComponent file_component(const RecordText& file, std::string name, double dt_s,
                             std::vector<double> samples_mps2) {
  FileComponent component;
  component.name = std::move(name);
  component.record.name = file.path.string();
  component.record.dt_s = dt_s;
  component.record.acceleration_mps2 = std::move(samples_mps2);
  if (file.zero_bytes > 0)
    component.record.notes.push_back(fmt::format(
        "ends with {} bytes of 0, which are left out: is the file whole?", file.zero_bytes));
  return component;
}

FileComponent file_component(const RecordText& file, std::string name, double dt_s,
                             std::vector<double> samples_mps2, RecordHeader header) {
  FileComponent component = file_component(file, std::move(name), dt_s, std::move(samples_mps2));
  component.record.source =
      fmt::format("{}{}{}{}{}, {}", header.event, header.event.empty() ? "" : ", ", header.station,
                  header.location.empty() ? "" : ", ", header.location, header.direction);
  component.header = std::move(header);
  return component;
}

}  // namespace glissade
