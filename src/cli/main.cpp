// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <string_view>
#include <system_error>

#include "commands.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/not_converged.hpp"
#include "glissade/io/written_number.hpp"
#include "help_formatter.hpp"

namespace {

constexpr int input_error_status = 2;

/// A full disk shows when the last of the output leaves the buffer.
void flush_standard_output() {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return;
  throw glissade::InputError({"standard output",
                              "cannot be written: " + std::generic_category().message(errno),
                              "make room on the disk or write elsewhere", ""});
}

/// The command that was reached, and its name as it is called: "suite show".
std::pair<const CLI::App*, std::string> reached_command(const CLI::App& program) {
  const CLI::App* reached = &program;
  std::string name = "glissade";
  while (!reached->get_subcommands().empty()) {
    reached = reached->get_subcommands().front();
    name += " " + reached->get_name();
  }
  return {reached, name};
}

/// The message of CLI11, except for a misspelt command or option, for which it says something else
/// or has no suggestion.
std::string message(const CLI::App& reached, const CLI::ParseError& error) {
  const std::vector<std::string> left = reached.remaining();
  const auto misspelt = [&](const std::string& word, const char* kind,
                            const std::vector<std::string>& known) {
    const std::string nearest = glissade::nearest_word(word, known);
    return word + " is not " + kind + (nearest.empty() ? "" : "; did you mean " + nearest + "?");
  };
  for (const std::string& word : left) {
    if (!word.starts_with("-")) continue;
    std::vector<std::string> options;
    for (const CLI::Option* option : reached.get_options()) {
      for (const std::string& name : option->get_lnames()) options.push_back("--" + name);
    }
    return misspelt(word.substr(0, word.find('=')), "an option", options);
  }
  std::vector<std::string> commands;
  for (const CLI::App* command : reached.get_subcommands([](const CLI::App*) { return true; }))
    commands.push_back(command->get_name());
  if (commands.empty() || left.empty()) return error.what();
  return misspelt(left.front(), "a command", commands);
}

/// An empty argument is a variable of the shell that is not set: `--out "$DIR"`.
void refuse_empty_arguments(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    const std::string_view text = argv[i];
    if (!text.empty() && !(text.starts_with("--") && text.ends_with('='))) continue;
    throw glissade::InputError({text.empty() && i > 1 ? argv[i - 1] : std::string(text),
                                "is given an empty value", "give a value, or leave it out", ""});
  }
}

/// Options with a unit at the end of their name take numbers with units, as the keys of files do.
void take_units(CLI::App& command) {
  for (CLI::Option* option : command.get_options()) {
    if (option->get_items_expected() == 0 || option->get_lnames().empty()) continue;
    const std::string name = "--" + option->get_lnames().front();
    option->transform(
        [name](const std::string& text) { return glissade::number_in_unit_of(name, text); }, "");
  }
  for (CLI::App* below : command.get_subcommands([](CLI::App*) { return true; }))
    take_units(*below);
}

int run_program(int argc, char** argv, const glissade::Communicator& world) {
  CLI::App program{"glissade: slip fragility of unanchored rooftop solar arrays"};
  program.set_version_flag("--version", "glissade " GLISSADE_VERSION);
  program.require_subcommand(1);
  program.formatter(std::make_shared<glissade::cli::HelpFormatter>());
  program.option_defaults()->always_capture_default();
  glissade::cli::add_init(program);
  glissade::cli::add_run(program, world);
  glissade::cli::add_clearance(program, world);
  glissade::cli::add_slide(program);
  glissade::cli::add_fit(program);
  glissade::cli::add_friction(program);
  glissade::cli::add_suite(program);
  glissade::cli::add_standards(program);
  glissade::cli::add_report(program);
  glissade::cli::add_explain(program);
  take_units(program);
  try {
    refuse_empty_arguments(argc, argv);
    program.parse(argc, argv);
    flush_standard_output();
    return 0;
  } catch (const CLI::ParseError& error) {
    const bool help_only = error.get_exit_code() == 0;  // --help, --version
    if (!world.is_root()) return help_only ? 0 : input_error_status;
    if (help_only) return program.exit(error);
    const auto [reached, name] = reached_command(program);
    fmt::print(stderr, "glissade: {}; see {} --help\n", message(*reached, error), name);
    return input_error_status;
  } catch (const glissade::cli::ExitStatus& exit) {
    return exit.status;
  } catch (const glissade::InputError& error) {
    fmt::print(stderr, "glissade: {}\n", error.what());
    if (!world.is_root()) world.abort(input_error_status);  // the other ranks would wait for ever
    return input_error_status;
  } catch (const glissade::NotConverged& error) {  // `run` counts these
    fmt::print(stderr, "glissade: the history did not converge: {}\n", error.what());
    return input_error_status;
  } catch (const std::bad_alloc&) {
    fmt::print(
        stderr,
        "glissade: there is not enough memory for this; take fewer samples, levels or ranks\n");
    if (world.size() > 1) world.abort(input_error_status);
    return input_error_status;
  }
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file-size limit becomes a write error, which is reported
  try {
    const glissade::MpiSession mpi(argc, argv);
    const glissade::Communicator world = mpi.world();
    const std::string_view command = argc > 1 ? argv[1] : "run";
    if (!world.is_root() && command != "run" && command != "merge" && command != "check" &&
        command != "clearance")
      return 0;  // the other commands are for one
    try {
      return run_program(argc, argv, world);
    } catch (const std::exception& error) {
      fmt::print(stderr, "glissade: internal error: {}\n", error.what());
      world.abort(1);
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "glissade: internal error: {}\n", error.what());
    return 1;
  }
}
