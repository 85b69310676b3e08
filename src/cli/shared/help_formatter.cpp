// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/help_formatter.hpp"

#include <fmt/format.h>

#include "glissade/core/wrap.hpp"

namespace glissade::cli {
namespace {

constexpr std::size_t names_width = 28;

/// "  NAME   what it is", the text in lines beside the name, or below a long one.
std::string entry(const std::string& name, const std::string& what) {
  const std::string text = wrapped(what, terminal_width, names_width);
  if (name.size() + 4 <= names_width)
    return fmt::format("  {:<{}}{}\n", name, names_width - 2, text);
  return fmt::format("  {}\n{:{}}{}\n", name, "", names_width, text);
}

}  // namespace

std::string HelpFormatter::make_description(const CLI::App* app) const {
  return wrapped(Formatter::make_description(app), terminal_width, 0) + "\n";
}

std::string HelpFormatter::make_usage(const CLI::App* app, std::string name) const {
  return wrapped(Formatter::make_usage(app, std::move(name)), terminal_width, 0) + "\n";
}

std::string HelpFormatter::make_option(const CLI::Option* option, bool is_positional) const {
  return entry(make_option_name(option, is_positional) + make_option_opts(option),
               make_option_desc(option));
}

std::string HelpFormatter::make_subcommand(const CLI::App* command) const {
  return entry(command->get_display_name(true), command->get_description());
}

}  // namespace glissade::cli
