// SPDX-License-Identifier: GPL-3.0-or-later
#include "toml_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

#include "glissade/core/contract.hpp"

namespace glissade {

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    const auto code = static_cast<unsigned char>(c);
    if (code < 0x20 || code == 0x7f)  // control characters are not allowed in a string
      result += fmt::format("\\u{:04X}", code);
    else
      result += c;
  }
  return result + '"';
}

std::string target_toml(const DesignTarget& target) {
  GLISSADE_EXPECTS(target.period_s.empty());
  if (target.sds_g > 0.0)
    return fmt::format("[target]\nedition = {}\nsds_g = {}\nsd1_g = {}\ntl_s = {}\n",
                       quoted(to_string(target.edition)), target.sds_g, target.sd1_g, target.tl_s);
  std::vector<std::string> classes;
  for (const SiteClass site : target.site_classes) classes.push_back(quoted(to_string(site)));
  return fmt::format(
      "[target]\n"
      "edition = {}\n"
      "ss_g = {}\n"
      "s1_g = {}\n"
      "site_classes = [{}]\n"
      "tl_s = {}\n",
      quoted(to_string(target.edition)), target.ss_g, target.s1_g, fmt::join(classes, ", "),
      target.tl_s);
}

}  // namespace glissade
