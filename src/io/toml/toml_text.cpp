// SPDX-License-Identifier: GPL-3.0-or-later
#include "toml/toml_text.hpp"

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

std::string list_of(const std::vector<double>& values) {
  return values.size() == 1 ? fmt::format("{}", values.front())
                            : fmt::format("[{}]", fmt::join(values, ", "));
}

std::string relative_path(const std::filesystem::path& file, const std::filesystem::path& folder) {
  return std::filesystem::proximate(std::filesystem::absolute(file),
                                    std::filesystem::absolute(folder.empty() ? "." : folder))
      .generic_string();
}

std::string path_from(const std::filesystem::path& file, const std::filesystem::path& folder) {
  return quoted(relative_path(file, folder));
}

std::vector<std::string> target_fields(const DesignTarget& target) {
  GLISSADE_EXPECTS(target.period_s.empty());
  std::vector<std::string> fields{"edition = " + quoted(to_string(target.edition))};
  const auto add = [&](const char* key, double value) {
    fields.push_back(fmt::format("{} = {}", key, value));
  };
  if (target.sds_g > 0.0) {
    add("sds_g", target.sds_g), add("sd1_g", target.sd1_g);
  } else {
    std::vector<std::string> classes;
    for (const SiteClass site : target.site_classes) classes.push_back(quoted(to_string(site)));
    add("ss_g", target.ss_g), add("s1_g", target.s1_g);
    fields.push_back(fmt::format("site_classes = [{}]", fmt::join(classes, ", ")));
  }
  add("tl_s", target.tl_s);
  std::vector<std::string> exceptions;
  for (const int exception : target.exceptions)
    exceptions.push_back(quoted(fmt::format("exception {} of 11.4.8", exception)));
  if (!exceptions.empty())
    fields.push_back(fmt::format("hazard_analysis = [{}]", fmt::join(exceptions, ", ")));
  return fields;
}

std::string target_toml(const DesignTarget& target) {
  return fmt::format("[target]\n{}\n", fmt::join(target_fields(target), "\n"));
}

}  // namespace glissade
