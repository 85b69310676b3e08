// SPDX-License-Identifier: GPL-3.0-or-later
//
// Under mpirun: each kind of step of several ranks fails on each of them in turn. Exit status 0 if
// all ranks then throw the same, and go on together. Nobody may wait for a rank that has failed.
#include <cstdio>
#include <functional>
#include <new>
#include <string>
#include <thread>
#include <vector>

#include "glissade/core/error.hpp"
#include "glissade/parallel/together.hpp"

namespace {

using namespace glissade;

struct Step {
  const char* name;
  enum class Of { all, root, others } of;
  /// `fail` throws on one rank.
  std::function<void(const Communicator& world, const std::function<void()>& fail)> run;
};

std::vector<char> message() { return std::vector<char>(100000, 'm'); }

const std::vector<Step>& steps() {
  static const std::vector<Step> all{
      {"together", Step::Of::all,
       [](const auto& world, const auto& fail) { together(world, fail); }},
      {"on_root", Step::Of::root,
       [](const auto& world, const auto& fail) { on_root(world, fail); }},
      {"work", Step::Of::all,
       [](const auto& world, const auto& fail) {
         self_schedule(world, 1000, [&](std::uint64_t) {
           std::this_thread::sleep_for(std::chrono::milliseconds(1));  // each rank gets some
           fail();
         });
       }},
      {"stop", Step::Of::all,
       [](const auto& world, const auto& fail) {
         self_schedule(
             world, 10, [](std::uint64_t) {},
             [&] {
               fail();
               return false;
             });
       }},
      {"part", Step::Of::all,
       [](const auto& world, const auto& fail) {
         share_parts(world, 1000, [&](std::size_t) {
           std::this_thread::sleep_for(std::chrono::milliseconds(1));
           fail();
           return std::vector<double>(10, 0.5);
         });
       }},
      {"next", Step::Of::others,
       [](const auto& world, const auto& fail) {
         int sent = 0;
         world.collect(
             5,
             [&] {
               if (++sent == 3) fail();
               return message();
             },
             [](const std::vector<char>&) {});
       }},
      {"receive", Step::Of::root, [](const auto& world, const auto& fail) {
         int received = 0;
         world.collect(5, message, [&](const std::vector<char>&) {
           if (++received == 3) fail();
         });
       }}};
  return all;
}

/// What this rank throws; "nothing".
std::string outcome(const Step& step, const Communicator& world, int failing) {
  try {
    step.run(world, [&] {
      if (world.rank() != failing) return;
      if (failing == 0) throw InputError({step.name, "fails", "", ""});
      throw std::bad_alloc();
    });
    return "nothing";
  } catch (const ExitStatus& ending) {
    return std::to_string(ending.status) + " " + ending.message;
  }
}

std::string expected(const Step& step, int failing) {
  if (failing == 0)
    return step.of == Step::Of::others ? "nothing" : "2 " + std::string(step.name) + ": fails";
  return step.of == Step::Of::root
             ? "nothing"
             : "2 rank " + std::to_string(failing) + ": there is not enough memory for this";
}

}  // namespace

int main(int argc, char** argv) {
  const MpiSession mpi(argc, argv);
  const Communicator world = mpi.world();
  bool right = world.size() > 1;
  for (const Step& step : steps()) {
    for (int failing = 0; failing < world.size(); ++failing) {
      const std::string seen = outcome(step, world, failing), wanted = expected(step, failing);
      if (seen.starts_with(wanted)) continue;
      right = false;
      std::fprintf(stderr, "rank %d: %s fails on %d: %s\n", world.rank(), step.name, failing,
                   seen.c_str());
    }
  }
  return right ? 0 : 1;
}
