// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "glissade/core/printable.hpp"
#include "records/formats/reading.hpp"
#include "text/encoding.hpp"

namespace glissade {
namespace {

// Binary files first; then by the marks of their headers; what has none last.
constexpr const RecordFormat* formats_in_order[] = {
    &sac_format,   &miniseed_format, &foreign_format,       &nied_format,   &dyna_format,
    &esd_format,   &afad_format,     &cosmos_format,        &csmip_format,  &smc_format,
    &usc_format,   &bhrc_format,     &asa_format,           &geonet_format, &cwb_format,
    &csmnc_format, &at2_format,      &headed_column_format, &table_format,  &column_format};

std::string without_blanks(std::string_view name) {
  std::string plain = lower_case(name);
  std::erase(plain, ' ');
  return plain;
}

/// "#1 (U1), #2 (U2)".
std::string listed_components(const std::vector<FileComponent>& components) {
  constexpr std::size_t most_listed = 40;
  std::string list;
  for (std::size_t i = 0; i < std::min(components.size(), most_listed); ++i) {
    const std::string& name = components[i].name;
    list +=
        fmt::format("{}#{}{}", i == 0 ? "" : ", ", i + 1, name.empty() ? "" : " (" + name + ")");
  }
  return components.size() > most_listed ? list + " ..." : list;
}

}  // namespace

std::span<const RecordFormat* const> record_formats() { return formats_in_order; }

RecordText record_text(const std::filesystem::path& file, std::string_view bytes) {
  RecordText record{file, bytes};
  const auto change = [&](std::string text) {
    record.own = std::make_shared<const std::string>(std::move(text));
    record.text = *record.own;
  };
  const auto refuse_if_empty = [&](const std::string& text) {
    if (text.empty()) refuse_record(record, "is no text", "give a text file in UTF-8");
  };
  if (is_utf16(record.text)) {
    std::string text = from_utf16(record.text);
    refuse_if_empty(text);
    change(std::move(text));
  }
  constexpr std::string_view behind_end("\0\x1a", 2);
  const std::size_t end = record.text.find_last_not_of(behind_end) + 1;
  const bool is_text = end > 0 && record.text.substr(0, end).find('\0') == std::string_view::npos;
  if (!is_text) return record;
  record.zero_bytes = static_cast<std::size_t>(std::ranges::count(record.text.substr(end), '\0'));
  record.text = record.text.substr(0, end);
  if (!is_utf8(record.text)) {
    std::string text = from_latin1(record.text);
    refuse_if_empty(text);
    change(std::move(text));
  }
  if (record.text.find('\n') == std::string_view::npos &&
      record.text.find('\r') != std::string_view::npos) {
    std::string text(record.text);
    std::ranges::replace(text, '\r', '\n');
    change(std::move(text));
  }
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

std::size_t picked_component(const std::filesystem::path& file,
                             const std::vector<FileComponent>& components,
                             const std::string& wanted) {
  if (wanted.empty() && components.size() == 1) return 0;
  if (wanted.empty())
    refuse_record(
        file.string(),
        fmt::format("has {} components: {}", components.size(), listed_components(components)),
        "name one behind the file: " + file.filename().string() + "#1");
  const bool is_position = wanted.find_first_not_of("0123456789") == std::string::npos;
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < components.size(); ++i) {
    const FileComponent& c = components[i];
    if (is_position ? wanted == std::to_string(i + 1)
                    : without_blanks(wanted) == without_blanks(c.name) ||
                          without_blanks(wanted) == without_blanks(c.direction))
      found.push_back(i);
  }
  if (found.size() == 1) return found.front();
  refuse_record(file.string(),
                fmt::format("{} component {}: {}", found.empty() ? "has no" : "has more than one",
                            in_quotes(wanted), listed_components(components)),
                "name one of them behind #, or give its number");
}

}  // namespace glissade
