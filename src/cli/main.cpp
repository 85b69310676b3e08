// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <csignal>
#include <cstdlib>
#include <exception>
#include <new>
#include <sstream>
#include <string_view>

#include "commands.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/printable.hpp"
#include "glissade/io/written_number.hpp"
#include "glissade/parallel/threads.hpp"
#include "glissade/parallel/together.hpp"
#include "shared/help_formatter.hpp"
#include "shared/put.hpp"
#include "shared/say.hpp"

namespace {

using glissade::ExitStatus;

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
    throw CLI::ValidationError(text.empty() && i > 1 ? argv[i - 1] : std::string(text),
                               "is given an empty value: give a value, or leave it out");
  }
}

/// Options with a unit at the end of their name take numbers with units, as the keys of files do.
void take_units(CLI::App& command) {
  for (CLI::Option* option : command.get_options()) {
    if (option->get_items_expected() == 0 || option->get_lnames().empty()) continue;
    const std::string name = "--" + option->get_lnames().front();
    option->transform(
        [name](const std::string& text) {
          try {
            return glissade::number_in_unit_of(name, text);
          } catch (const glissade::InputError& error) {
            throw CLI::ValidationError(error.what());
          }
        },
        "");
  }
  for (CLI::App* below : command.get_subcommands([](CLI::App*) { return true; }))
    take_units(*below);
}

/// How the program ends, on every rank.
ExitStatus run_program(int argc, char** argv, const glissade::Communicator& world) {
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
  glissade::cli::add_building(program);
  glissade::cli::add_report(program);
  glissade::cli::add_explain(program);
  take_units(program);
  try {
    refuse_empty_arguments(argc, argv);
    program.parse(argc, argv);
    return {};
  } catch (const CLI::ParseError& error) {  // the ranks have the same arguments
    if (error.get_exit_code() == 0) {       // --help, --version
      std::ostringstream text;
      program.exit(error, text);
      if (world.is_root()) glissade::cli::put_text(text.str());
      return {};
    }
    const auto [reached, name] = reached_command(program);
    return {2, fmt::format("{}; see {} --help", message(*reached, error), name)};
  } catch (const ExitStatus& ending) {  // of a step of all ranks
    return ending;
  }
}

/// Says what there is to say at the end of the program; its exit status.
int end_with(const ExitStatus& ending) {
  if (!ending.message.empty())
    glissade::cli::say("glissade: {}\n", glissade::printable(ending.message));
  try {
    glissade::cli::end_of_results(ending.status);
    return ending.status;
  } catch (const glissade::InputError& error) {
    if (ending.status == 0) glissade::cli::say("glissade: {}\n", error.what());
    return ending.status == 0 ? 2 : ending.status;
  }
}

constexpr const char* no_memory = "glissade: there is not enough memory for this\n";

/// The same of the exception that is being handled, also where no memory is left for its message.
int end_with_exception(int rank) {
  try {
    ExitStatus ending = glissade::exit_status_of_exception();
    if (rank > 0) ending.message = fmt::format("rank {}: {}", rank, ending.message);
    return end_with(ending);
  } catch (const std::bad_alloc&) {
    glissade::cli::say_text(no_memory);
    return 2;
  }
}

/// The other commands are for one process.
bool is_for_all_ranks(std::string_view command) {
  return command == "run" || command == "merge" || command == "check" || command == "clearance";
}

/// To those that the system starts.
void limit_threads() {
  const int wanted = tbb::this_task_arena::max_concurrency();
  const int threads = glissade::startable_threads(wanted);
  if (threads == wanted) return;
  // Never removed: oneTBB would start the others then.
  static const auto* const limit = new tbb::global_control(
      tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  static_cast<void>(limit);
}

int run_on(const glissade::Communicator& world, int argc, char** argv) {
  try {
    if (world.size() == 1) limit_threads();  // ranks do so where they start them
    const ExitStatus ending = run_program(argc, argv, world);
    return world.is_root() ? end_with(ending) : ending.status;
  } catch (...) {
    const int status = end_with_exception(world.rank());
    if (world.size() > 1) world.abort(status);  // the others would wait for this one for ever
    return status;
  }
}

/// Memory can end in a function that must not throw: of CLI11, toml++ or the standard library. What
/// is on the disk is as after a kill.
[[noreturn]] void end_in_function_that_may_not_throw() noexcept {
  try {
    if (std::current_exception()) throw;
  } catch (const std::bad_alloc&) {
    glissade::cli::say_text(no_memory);
    std::_Exit(2);
  } catch (...) {
  }
  std::abort();
}

}  // namespace

int main(int argc, char** argv) {
  std::set_terminate(end_in_function_that_may_not_throw);
  glissade::cli::take_standard_files();
  std::signal(SIGXFSZ, SIG_IGN);  // a file-size limit becomes a write error, which is reported
  try {
    const glissade::MpiSession mpi(argc, argv);
    if (is_for_all_ranks(argc > 1 ? argv[1] : "run")) return run_on(mpi.world(), argc, argv);
    return mpi.world().is_root() ? run_on(glissade::Communicator::serial(), argc, argv) : 0;
  } catch (...) {
    return end_with_exception(0);
  }
}
