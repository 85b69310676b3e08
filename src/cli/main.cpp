// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <csignal>
#include <cstdio>

#include "commands.hpp"
#include "glissade/core/error.hpp"

namespace {

constexpr int input_error_status = 2;

int run_program(int argc, char** argv, const glissade::Communicator& world) {
  CLI::App program{"glissade: slip fragility of unattached rooftop solar arrays"};
  program.set_version_flag("--version", "glissade " GLISSADE_VERSION);
  program.require_subcommand(1);
  program.option_defaults()->always_capture_default();
  glissade::cli::add_run(program, world);
  glissade::cli::add_slide(program);
  glissade::cli::add_fit(program);
  glissade::cli::add_suite(program);
  glissade::cli::add_standards(program);
  glissade::cli::add_report(program);
  try {
    program.parse(argc, argv);
    return 0;
  } catch (const CLI::ParseError& error) {
    const bool asked = error.get_exit_code() == 0;  // --help, --version
    if (!world.is_root()) return asked ? 0 : input_error_status;
    if (asked) return program.exit(error);
    fmt::print(stderr, "glissade: {}; see glissade --help\n", error.what());
    return input_error_status;
  } catch (const glissade::cli::ExitStatus& exit) {
    return exit.status;
  } catch (const glissade::InputError& error) {
    fmt::print(stderr, "glissade: {}\n", error.what());
    return input_error_status;
  }
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file-size limit becomes a write error, which is told
  try {
    const glissade::MpiSession mpi(argc, argv);
    const glissade::Communicator world = mpi.world();
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
