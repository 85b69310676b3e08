// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "glissade/core/printable.hpp"
#include "glissade/core/wrap.hpp"
#include "shared/say.hpp"

// All that commands print to standard output. Names and paths that stand in it do not act on the
// terminal (printable).
namespace glissade::cli {

inline void put_text(const std::string& text) { write_result(printable(text)); }

template <class... Values>
void put(fmt::format_string<Values...> text, Values&&... values) {
  put_text(fmt::format(text, std::forward<Values>(values)...));
}

/// As it is printed or stands in a file; bytes that are not UTF-8, of a path, become U+FFFD.
inline std::string json_text(const nlohmann::ordered_json& json) {
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

/// 0, not given, becomes null.
inline nlohmann::ordered_json or_null(double value) {
  return value > 0.0 ? nlohmann::ordered_json(value) : nlohmann::ordered_json();
}

/// In lines of the terminal, with so many blanks before those after the first.
inline void put_lines(const std::string& text, std::size_t indent) {
  put("{}\n", wrapped(text, terminal_width, indent));
}
inline void put_warning(const std::string& text) { put_lines("WARNING: " + text, 2); }
inline void put_warnings(const std::vector<std::string>& texts) {
  for (const std::string& text : texts) put_warning(text);
}
inline void put_note(const std::string& text) { put_lines("note  " + text, 6); }

inline void put_json(const nlohmann::ordered_json& json) { put_text(json_text(json)); }

}  // namespace glissade::cli
