// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/component_name.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <ranges>

#include "glissade/core/printable.hpp"
#include "records/formats/reading.hpp"
#include "text/scan.hpp"

namespace glissade {
namespace {

constexpr std::string_view separators = "._- ";

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_one_of(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::ranges::find(words, word) != words.end();
}

ComponentDirection horizontal(double azimuth_deg) {
  const double turned = std::fmod(azimuth_deg, 360.0);
  return {false, false, turned < 0.0 ? turned + 360.0 : turned, 0};
}

bool is_azimuth(std::string_view text) {
  return text.size() == 3 && std::ranges::all_of(text, is_digit) && text <= "360";
}

/// A token of a name that names a component wherever it stands; of one letter only at the end.
bool is_direction_token(std::string_view token, bool is_last) {
  if (is_last && is_azimuth(token)) return true;
  if (token.size() < (is_last ? 1U : 2U) || is_digit(token.front())) return false;
  return component_direction(token).has_value();
}

/// "20140824T102244Z", as data centres end names.
bool is_utc_time(std::string_view token) {
  constexpr std::size_t length = 16, between = 8;
  if (token.size() != length) return false;
  for (std::size_t i = 0; i < length; ++i)
    if (i == between ? token[i] != 'T' : i == length - 1 ? token[i] != 'Z' : !is_digit(token[i]))
      return false;
  return true;
}

/// The direction at the end of a token, "GIL067", "HECVER", "20140203E"; 0: none. The last digits
/// of a longer number, "eq2019", are one only where the direction is stated.
std::size_t direction_suffix(std::string_view token,
                             const std::optional<ComponentDirection>& stated) {
  if (is_utc_time(token)) return 0;
  constexpr std::size_t azimuth = 3;
  const auto is_letter = [](char c) { return !is_digit(c); };
  if (token.size() > azimuth && is_azimuth(token.substr(token.size() - azimuth)) &&
      std::ranges::any_of(token, is_letter) &&
      (stated || is_letter(token[token.size() - azimuth - 1])))
    return azimuth;
  const std::string lower = lower_case(token);
  for (const std::string_view word : {"dwn", "ver", "vrt", "up"})
    if (lower.size() > word.size() && lower.ends_with(word) &&
        (word != "up" || (stated && stated->is_vertical)))
      return word.size();
  if (lower.size() > 1 && is_digit(lower[lower.size() - 2]) &&
      is_one_of(std::string_view(lower).substr(lower.size() - 1), {"n", "e", "v", "z"}))
    return 1;
  return 0;
}

}  // namespace

std::optional<ComponentDirection> component_direction(std::string_view word) {
  const std::string plain = plain_direction(trimmed(word));
  const std::string lower = lower_case(plain);
  if (const auto azimuth = parse_number(plain)) {
    if (std::isfinite(*azimuth) && std::abs(*azimuth) <= 360.0) return horizontal(*azimuth);
    return std::nullopt;
  }
  // L1, V2 and T3 of BHRC.
  const bool is_numbered = lower.size() == 2 && is_digit(lower[1]);
  if (is_numbered && lower[0] == 'l') return ComponentDirection{false, false, {}, 1};
  if (is_numbered && lower[0] == 't') return ComponentDirection{false, false, {}, 2};
  if (is_numbered && lower[0] == 'v') return ComponentDirection{true, false, {}, 0};
  if (is_one_of(lower, {"up", "ver", "vrt", "u3", "uz", "az", "a3"}))
    return ComponentDirection{true, false, {}, 0};
  if (is_one_of(lower, {"dwn", "down", "dn"})) return ComponentDirection{true, true, {}, 0};
  if (is_one_of(lower, {"s"})) return horizontal(180.0);
  if (is_one_of(lower, {"w"})) return horizontal(270.0);
  if (is_one_of(lower, {"h1", "l", "ln", "long", "x", "u1", "ux", "ax", "a1", "fn"}))
    return ComponentDirection{false, false, {}, 1};
  if (is_one_of(lower, {"h2", "t", "tr", "tran", "y", "u2", "uy", "ay", "a2", "fp"}))
    return ComponentDirection{false, false, {}, 2};
  const auto seed = seed_channel(lower);
  switch (seed ? seed->orientation : '\0') {
    case '3':
      return ComponentDirection{true, false, {}, 0};
    case '1':
      return ComponentDirection{false, false, {}, 1};
    case '2':
      return ComponentDirection{false, false, {}, 2};
    default:
      return std::nullopt;
  }
}

std::string plain_line(std::string_view text) {
  constexpr std::size_t most = 100;
  return printable_name(single_blanks(text.substr(0, most)));
}

SplitName split_direction(std::string_view stem, const std::optional<ComponentDirection>& stated) {
  std::size_t end = stem.size();
  for (bool is_last = true; end > 0; is_last = false) {
    const std::size_t before = stem.find_last_of(separators, end - 1);
    const std::size_t begin = before == std::string_view::npos ? 0 : before + 1;
    const std::string_view token = stem.substr(begin, end - begin);
    if (!token.empty() && is_direction_token(token, is_last)) {
      std::string rest(stem.substr(0, begin));
      while (!rest.empty() && separators.find(rest.back()) != std::string_view::npos)
        rest.pop_back();
      return {rest + std::string(stem.substr(end)), std::string(token)};
    }
    if (const std::size_t suffix = is_last ? direction_suffix(token, stated) : 0; suffix > 0)
      return {std::string(stem.substr(0, end - suffix)), std::string(stem.substr(end - suffix))};
    if (before == std::string_view::npos) break;
    end = before;
  }
  return {std::string(stem), ""};
}

std::string stem_of(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  const std::size_t point = name.rfind('.');
  const bool is_ending = point != std::string::npos && point > 0 && name.size() - point <= 6 &&
                         std::ranges::any_of(name.substr(point + 1),
                                             [](unsigned char c) { return std::isalpha(c) != 0; });
  return is_ending ? name.substr(0, point) : name;
}

std::string record_sequence_number(std::string_view file_name) {
  if (!lower_case(file_name.substr(0, 3)).starts_with("rsn")) return "";
  std::size_t end = 3;
  while (end < file_name.size() && is_digit(file_name[end])) ++end;
  const bool ends_there = end < file_name.size() && !std::isalpha(file_name[end]);
  return ends_there ? std::string(file_name.substr(3, end - 3)) : "";
}

std::string channel_in_name(std::string_view stem) {
  for (const std::string_view token :
       std::views::split(stem, '.') | std::views::transform([](auto part) {
         return std::string_view(part.begin(), part.end());
       }))
    if (seed_channel(lower_case(token))) return std::string(token);
  return "";
}

std::string peer_direction(std::string_view stem) {
  return record_sequence_number(stem).empty()
             ? ""
             : split_direction(stem, ComponentDirection{.is_vertical = true}).direction;
}

}  // namespace glissade
