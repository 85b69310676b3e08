// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "glissade/core/io_error.hpp"

// Input that is wrong in an option, and is read by a library that does not know the options.
namespace glissade::cli {

/// What `read` gives; its problems are changed.
template <class Read, class Change>
auto with_changed_problems(const Change& change, const Read& read) {
  try {
    return read();
  } catch (const IoError&) {  // is of a file
    throw;
  } catch (const InputError& error) {
    std::vector<Problem> problems = error.problems();
    for (Problem& problem : problems) change(problem);
    throw InputError(std::move(problems));
  }
}

/// What `read` makes of the value of an option.
template <class Read>
auto of_option(const char* option, const Read& read) {
  return with_changed_problems([=](Problem& problem) { problem.where = option; }, read);
}

/// Where a study cannot be computed that the program made of the user's file `of`, that file is
/// named; empty: the study is the user's.
template <class Read>
auto with_place_of(const std::filesystem::path& study, const std::filesystem::path& of,
                   const Read& read) {
  return with_changed_problems(
      [&](Problem& problem) {
        if (!of.empty() && problem.where == study.string()) problem.where = of.string();
      },
      read);
}

}  // namespace glissade::cli
