// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/io/record_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "glissade/core/error.hpp"
#include "glissade/core/file.hpp"
#include "glissade/core/units.hpp"
#include "glissade/motion/improbable.hpp"
#include "glissade/motion/intensity.hpp"
#include "records/formats/reading.hpp"
#include "records/time_column.hpp"
#include "text/scan.hpp"
#include "text/utf16.hpp"

namespace glissade {
namespace {

void refuse_impossible(const Record& record) {
  const double pga_g =
      peak_ground_acceleration_mps2(record.acceleration_mps2) / standard_gravity_mps2;
  if (pga_g > most_possible_g)
    refuse_record(record.name,
                  fmt::format("PGA of {:.3g} g: no ground has shaken with more than {:g} g", pga_g,
                              most_possible_g),
                  "check its units; a factor is the record's scale");
}

/// As a spreadsheet or DOS leaves it: UTF-16, lines that end with \r alone, an end-of-file mark.
RecordText load_record(const std::filesystem::path& file) {
  RecordText record{file, read_text_file(file)};
  if (is_utf16(record.text)) record.text = from_utf16(record.text);
  if (record.text.ends_with('\x1a')) record.text.pop_back();
  const bool is_text = record.text.find('\0') == std::string::npos;
  if (is_text && record.text.find('\n') == std::string::npos)
    std::ranges::replace(record.text, '\r', '\n');
  return record;
}

const RecordFormat& format_of(const RecordText& record) {
  const auto formats = record_formats();
  const auto binary = std::ranges::find_if(
      formats, [&](const RecordFormat* f) { return f->is_binary && f->matches(record); });
  if (binary != formats.end()) return **binary;
  refuse_no_text(record.path, record.text);
  return **std::ranges::find_if(
      formats, [&](const RecordFormat* f) { return !f->is_binary && f->matches(record); });
}

}  // namespace

ComponentAddress split_address(const std::string& name) {
  const std::size_t mark = name.rfind('#');
  std::error_code ignored;
  if (mark == std::string::npos || mark == 0 || std::filesystem::exists(name, ignored))
    return {name, ""};
  return {name.substr(0, mark), name.substr(mark + 1)};
}

Record read_record(const std::filesystem::path& file, const RecordFileOptions& options) {
  if (options.dt_s) check_step(file.string(), shortest_decimal(*options.dt_s), *options.dt_s);
  const RecordText text = load_record(file);
  std::vector<FileComponent> components = format_of(text).read(text, options);
  Record record =
      std::move(components[picked_component(file, components, options.component)].record);
  if (record.acceleration_mps2.empty())
    refuse_record(file.string(), "the file holds no samples", what_is_read);
  refuse_impossible(record);
  return record;
}

}  // namespace glissade
