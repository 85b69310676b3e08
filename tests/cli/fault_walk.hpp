// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmock/gmock.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "cli/child.hpp"
#include "cli/one_package.hpp"

// What commands do where a call of the system (inject.cpp) or an allocation (faults_memory.cpp)
// fails.
namespace glissade::test {

/// Functions of the system (inject.cpp) and the errors by which a call of each can fail.
struct Function {
  const char* name;
  std::vector<int> errors;
};
extern const std::vector<Function> system_functions;

/// Calls of each function that are made to fail, as GLISSADE_FAULTS states; 0: one of each.
long wanted_calls();

using Files = std::map<std::string, std::string>;
using Prepare = std::function<void(const fs::path& in, const fs::path& out)>;

/// A command that writes, of which the calls fail one by one.
struct Walked {
  std::string name;            ///< of the test
  std::string arguments;       ///< of glissade; OUT is its folder, IN that of what it reads
  Prepare prepare;             ///< what is there before
  bool prints_result = false;  ///< its output has no times: what is printed is compared too
  std::string again = "";      ///< the command that then makes all, where none is stated;
                               ///< empty: the same
  bool keeps = false;          ///< what was there before is there after a failure
};

inline void PrintTo(const Walked& walked, std::ostream* out) { *out << walked.name; }

inline std::string in_quotes(const fs::path& path) { return "'" + path.string() + "'"; }

/// Its arguments with the paths.
std::string line_of(const std::string& arguments, const fs::path& in, const fs::path& out);

/// How often, of the calls of a function that were made to fail.
struct Tally {
  long calls = 0, failed = 0, reported = 0, whole = 0, silent = 0, lost = 0, signals = 0,
       internal = 0;
};

class FaultWalk : public testing::TestWithParam<Walked> {
 protected:
  void TearDown() override;  ///< prints the tallies
  void begin();              ///< the command undisturbed
  void prepare() const;
  std::string line(const std::string& variables = "", const std::string& program = "") const;
  /// How many calls there are of each function.
  std::map<std::string, long> count(const std::string& program) const;
  /// One call fails, or all from it on.
  void fail(const std::string& function, const std::string& program, int error, bool only, long at);
  /// Where all are wanted, each call by each error, alone and with all that follow; else so many of
  /// each function; else one of each.
  void walk(const std::string& function, const std::vector<int>& errors, long calls,
            const std::string& program);

  static const ScratchFolder& folder() {
    static const ScratchFolder one;  // paths are in what is kept
    return one;
  }
  WithoutWeasyprint path_;
  fs::path in_ = folder().path("in"), out_ = folder().path("out");
  Files before_, undisturbed_;
  std::string printed_;
  std::map<std::string, Tally> tallies_;

 private:
  std::string difference_when_mended(const Finished& child) const;
};

void write_input(const fs::path& file, const std::string& text);
/// Writes one file of the folder of what a command reads.
Prepare with(const std::string& name, std::string (*text)());
/// A calculation whose studies are finished, and what is made of them is not.
Prepare finished_calculation(std::string (*text)());
Prepare finished_run();

}  // namespace glissade::test
