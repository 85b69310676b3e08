// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/encoding.hpp"

#include <cstdint>

namespace glissade {
namespace {

constexpr std::string_view little_endian_mark = "\xff\xfe", big_endian_mark = "\xfe\xff";
constexpr char32_t no_character = 0xFFFD;
constexpr std::size_t most_foreign = 1'000'000;  // characters that are not ASCII

void append_utf8(char32_t c, std::string& text) {
  const auto part = [](char32_t bits) { return static_cast<char>(bits); };
  if (c < 0x80) {
    text += part(c);
  } else if (c < 0x800) {
    text += {part(0xC0 | c >> 6), part(0x80 | (c & 0x3F))};
  } else if (c < 0x10000) {
    text += {part(0xE0 | c >> 12), part(0x80 | (c >> 6 & 0x3F)), part(0x80 | (c & 0x3F))};
  } else {
    text += {part(0xF0 | c >> 18), part(0x80 | (c >> 12 & 0x3F)), part(0x80 | (c >> 6 & 0x3F)),
             part(0x80 | (c & 0x3F))};
  }
}

}  // namespace

bool is_utf16(std::string_view bytes) {
  return bytes.starts_with(little_endian_mark) || bytes.starts_with(big_endian_mark);
}

std::string from_utf16(std::string_view bytes) {
  const bool little = bytes.starts_with(little_endian_mark);
  const auto unit = [&](std::size_t at) -> char32_t {
    const auto low = static_cast<std::uint8_t>(bytes[little ? at : at + 1]),
               high = static_cast<std::uint8_t>(bytes[little ? at + 1 : at]);
    return static_cast<char32_t>(high << 8 | low);
  };
  const auto is_high = [](char32_t c) { return c >= 0xD800 && c < 0xDC00; };
  const auto is_low = [](char32_t c) { return c >= 0xDC00 && c < 0xE000; };
  std::string text;
  text.reserve(bytes.size() / 2);
  std::size_t foreign = 0;
  for (std::size_t at = 2; at + 1 < bytes.size(); at += 2) {
    const char32_t c = unit(at);
    if (c >= 0x80 && ++foreign > most_foreign) return "";
    if (!is_high(c) && !is_low(c)) {
      append_utf8(c, text);
    } else if (is_high(c) && at + 3 < bytes.size() && is_low(unit(at + 2))) {
      append_utf8(0x10000 + ((c - 0xD800) << 10) + (unit(at + 2) - 0xDC00), text);
      at += 2;
    } else {
      append_utf8(no_character, text);
    }
  }
  return text;
}

std::string from_latin1(std::string_view bytes) {
  std::string text;
  text.reserve(bytes.size());
  std::size_t foreign = 0;
  for (const char byte : bytes) {
    const auto c = static_cast<std::uint8_t>(byte);
    if (c >= 0x80 && ++foreign > most_foreign) return "";
    append_utf8(c >= 0x80 && c < 0xA0 ? no_character : c, text);
  }
  return text;
}

}  // namespace glissade
