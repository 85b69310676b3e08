// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <string>
#include <utility>

#include "say.hpp"

// All that commands print to standard output.
namespace glissade::cli {

inline void put_text(const std::string& text) { write_result(text); }

template <class... Values>
void put(fmt::format_string<Values...> text, Values&&... values) {
  put_text(fmt::format(text, std::forward<Values>(values)...));
}

}  // namespace glissade::cli
