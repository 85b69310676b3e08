// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/io/record_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "glissade/core/error.hpp"
#include "glissade/core/file.hpp"
#include "glissade/core/units.hpp"
#include "records/at2_header.hpp"
#include "records/time_column.hpp"
#include "scan.hpp"

namespace glissade {
namespace {

constexpr const char* what_is_read =
    "give a PEER AT2 file, one column of accelerations, or two columns time and acceleration, with "
    "# before comments";
constexpr double largest_believable_g =
    3.0;  // few records exceed it; those need their units stated

enum class HeaderUnits { none, g, mps2, cmps2, velocity, displacement, unknown };

HeaderUnits header_units(const std::string& text) {
  if (text.empty()) return HeaderUnits::none;
  std::string unit = text;  // cm/sec**2, cm/sec^2, cm/sec/sec -> cm/s2
  for (const auto& [from, to] :
       std::initializer_list<std::pair<std::string_view, std::string_view>>{
           {"sec", "s"}, {"**", ""}, {"^", ""}, {"/s/s", "/s2"}}) {
    for (std::size_t at; (at = unit.find(from)) != std::string::npos;)
      unit.replace(at, from.size(), to);
  }
  constexpr std::array<std::pair<std::string_view, HeaderUnits>, 13> known = {
      {{"g", HeaderUnits::g},
       {"g's", HeaderUnits::g},
       {"gs", HeaderUnits::g},
       {"m/s2", HeaderUnits::mps2},
       {"cm/s2", HeaderUnits::cmps2},
       {"gal", HeaderUnits::cmps2},
       {"gals", HeaderUnits::cmps2},
       {"cm/s", HeaderUnits::velocity},
       {"m/s", HeaderUnits::velocity},
       {"in/s", HeaderUnits::velocity},
       {"cm", HeaderUnits::displacement},
       {"m", HeaderUnits::displacement},
       {"in", HeaderUnits::displacement}}};
  for (const auto& [name, units] : known) {
    if (unit == name) return units;
  }
  return HeaderUnits::unknown;
}

double mps2_per_unit(AccelerationUnits units) {
  switch (units) {
    case AccelerationUnits::g:
      return standard_gravity_mps2;
    case AccelerationUnits::mps2:
      return 1.0;
    case AccelerationUnits::cmps2:
      return 0.01;
  }
  return 1.0;
}

/// A finite number, or an error that names the token.
double parse_finite(const std::filesystem::path& file, std::size_t line, std::string_view token,
                    const char* what) {
  const std::optional<double> value = parse_number(token);
  if (!value) {
    throw InputError({place(file, line),
                      std::string(what) + " " + in_quotes(token) + " is not a number", what_is_read,
                      ""});
  }
  if (!std::isfinite(*value)) {
    throw InputError({place(file, line),
                      std::string(what) + " " + in_quotes(token) + " is not finite",
                      "repair the record: every sample must be a finite number", ""});
  }
  return *value;
}

/// A sample in m/s2, finite in these too.
double parse_sample(const std::filesystem::path& file, std::size_t line, std::string_view token,
                    double unit_mps2) {
  const double sample_mps2 = unit_mps2 * parse_finite(file, line, token, "the value");
  if (!std::isfinite(sample_mps2)) {
    throw InputError({place(file, line), "the value " + in_quotes(token) + " is not finite in m/s2",
                      "repair the record, or correct its units", ""});
  }
  return sample_mps2;
}

AccelerationUnits at2_units(const std::filesystem::path& file, const At2Header& header,
                            const std::optional<AccelerationUnits>& wanted) {
  const std::string where = place(file, header.units_line);
  const auto refuse = [&](const std::string& what, const std::string& suggestion) {
    throw InputError({where, what, suggestion, ""});
  };
  const auto agreed = [&](AccelerationUnits stated) {
    if (wanted && *wanted != stated) {
      refuse("the header says the units are " + in_quotes(header.units) + ", the option says " +
                 to_string(*wanted),
             "leave the units out, or correct the file");
    }
    return stated;
  };
  switch (header_units(header.units)) {
    case HeaderUnits::none:
      break;
    case HeaderUnits::g:
      return agreed(AccelerationUnits::g);
    case HeaderUnits::mps2:
      return agreed(AccelerationUnits::mps2);
    case HeaderUnits::cmps2:
      return agreed(AccelerationUnits::cmps2);
    case HeaderUnits::velocity:
      refuse("units " + in_quotes(header.units) + ": this is a velocity file",
             "give the acceleration file (.AT2)");
      break;
    case HeaderUnits::displacement:
      refuse("units " + in_quotes(header.units) + ": this is a displacement file",
             "give the acceleration file (.AT2)");
      break;
    case HeaderUnits::unknown:
      if (!wanted)
        refuse("the units " + in_quotes(header.units) + " are not known",
               "give units as g, m/s2 or cm/s2");
      break;
  }
  return wanted.value_or(AccelerationUnits::g);
}

double at2_step(const std::filesystem::path& file, const At2Header& header,
                const std::optional<double>& wanted) {
  if (wanted) {
    // Mends a step printed with too few decimals (.0039 for 1/256), not another step.
    const double stated = header.dt_s.value_or(*wanted);
    if (std::abs(stated - *wanted) > 0.02 * *wanted) {
      throw InputError(
          {place(file, header.lines),
           "the header's DT = " + header.dt_text + " is not dt_s = " + shortest_decimal(*wanted),
           "leave dt_s (--dt-s) out: the file states its step", ""});
    }
    return *wanted;
  }
  const std::string where = place(file, header.lines);
  if (header.dt_text.empty()) {
    throw InputError(
        {where, "the header has NPTS but no DT", "give the step with dt_s (--dt-s)", ""});
  }
  check_step(where, header.dt_text, header.dt_s.value_or(0.0));
  return *header.dt_s;
}

Record read_at2(const std::filesystem::path& file, std::string_view text, const At2Header& header,
                const RecordFileOptions& options) {
  const double unit_mps2 = mps2_per_unit(at2_units(file, header, options.units));
  Record record{file.string(), at2_step(file, header, options.dt_s), {}};
  LineReader reader(text);
  while (reader.next()) {
    if (reader.number() <= header.lines) continue;
    for (const std::string_view token : fields(reader.line())) {
      record.acceleration_mps2.push_back(parse_sample(file, reader.number(), token, unit_mps2));
    }
  }
  const std::size_t found = record.acceleration_mps2.size();
  if (!header.npts || *header.npts != found) {
    const std::string stated = header.npts ? std::to_string(*header.npts) : "no whole number";
    throw InputError(
        {place(file, header.lines),
         "NPTS is " + stated + ", the file contains " + std::to_string(found) + " values",
         "the file is cut short or its header is wrong: get it again", ""});
  }
  return record;
}

void check_believable(const Record& record) {
  double peak = 0.0;
  for (const double a : record.acceleration_mps2) peak = std::max(peak, std::abs(a));
  const double peak_g = peak / standard_gravity_mps2;
  if (peak_g <= largest_believable_g) return;
  throw InputError({record.name,
                    "a peak acceleration of " + shortest_decimal(peak_g) +
                        " g is not plausible without stated units",
                    "give the units (--units): g, m/s2 or cm/s2", ""});
}

/// A column that begins with the number of the values after it, or after it and the step, has a
/// header that is no comment.
void refuse_count(const Record& record, double unit_mps2) {
  const std::vector<double>& a = record.acceleration_mps2;
  const double first = std::round(a.front() / unit_mps2), after = static_cast<double>(a.size() - 1);
  if (a.size() < 8 || (first != after && first != after - 1.0)) return;
  throw InputError({record.name,
                    fmt::format("begins with {:g}, the number of values that follow: a header, not "
                                "an acceleration",
                                first),
                    "put # before the lines of the header, and give the step with dt_s (--dt-s)",
                    ""});
}

Record read_columns(const std::filesystem::path& file, std::string_view text,
                    const RecordFileOptions& options) {
  Record record{file.string(), 0.0, {}};
  const double unit_mps2 = mps2_per_unit(options.units.value_or(AccelerationUnits::g));
  TimeColumn time;
  std::size_t columns = 0;
  LineReader reader(text);
  while (reader.next()) {
    if (is_blank_or_comment(reader.line())) continue;
    const std::vector<std::string_view> parts = fields(reader.line());
    const std::size_t line = reader.number();
    if (columns == 0) {
      parse_finite(file, line, parts.front(),
                   "the value");  // text is reported as text, however many words
      columns = parts.size();
    }
    if (parts.size() > 2 || parts.size() != columns) {
      throw InputError({place(file, line),
                        std::to_string(parts.size()) +
                            (parts.size() == 1 ? " column" : " columns") +
                            (parts.size() > 2 ? "; at most two are read"
                                              : ", " + std::to_string(columns) + " above"),
                        what_is_read, ""});
    }
    if (columns == 2) time.add(parse_finite(file, line, parts[0], "the time"), parts[0], line);
    record.acceleration_mps2.push_back(parse_sample(file, line, parts.back(), unit_mps2));
  }
  if (columns == 0)
    throw InputError({file.string(), "the file holds no samples", what_is_read, ""});
  if (columns == 2) {
    record.dt_s = step_of(file, time, options.dt_s);
  } else if (options.dt_s) {
    refuse_count(record, unit_mps2);
    record.dt_s = *options.dt_s;
  } else {
    throw InputError({file.string(), "one column does not give the time step",
                      "give it with dt_s (--dt-s)", ""});
  }
  if (!options.units) check_believable(record);
  return record;
}

}  // namespace

AccelerationUnits parse_acceleration_units(const std::string& text) {
  if (text == "g") return AccelerationUnits::g;
  if (text == "m/s2") return AccelerationUnits::mps2;
  if (text == "cm/s2" || text == "gal") return AccelerationUnits::cmps2;
  throw InputError(
      {"", "units " + in_quotes(text) + " are not known", "use g, m/s2, cm/s2 or gal", ""});
}

std::string to_string(AccelerationUnits units) {
  switch (units) {
    case AccelerationUnits::g:
      return "g";
    case AccelerationUnits::mps2:
      return "m/s2";
    case AccelerationUnits::cmps2:
      return "cm/s2";
  }
  return "";
}

Record read_record(const std::filesystem::path& file, const RecordFileOptions& options) {
  if (options.dt_s) check_step(file.string(), shortest_decimal(*options.dt_s), *options.dt_s);
  const std::string text = read_text_file(file);
  if (text.find('\0') != std::string::npos) {
    throw InputError({file.string(), "is not a text file", what_is_read, ""});
  }
  const std::optional<At2Header> header = find_at2_header(text);
  Record record =
      header ? read_at2(file, text, *header, options) : read_columns(file, text, options);
  if (record.acceleration_mps2.empty()) {
    throw InputError({file.string(), "the file holds no samples", what_is_read, ""});
  }
  return record;
}

}  // namespace glissade
