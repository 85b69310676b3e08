// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <utility>

#include "cli/fault_walk.hpp"

namespace glissade::test {
namespace {

using testing::HasSubstr;

/// Its PDF is printed by a script in the place of WeasyPrint.
class Printing : public FaultWalk {
 protected:
  Finished print(const std::string& script) {
    prepare();  // the first time without WeasyPrint: no PDF is listed
    path_.put(script);
    return run_shell(line());
  }
  static inline const std::string a_pdf_ = R"(printf '%%PDF-1.7\nxref\nstartxref\n9\n%%%%EOF\n')";
  const fs::path pdf_ = out_ / "product.pdf";
};
INSTANTIATE_TEST_SUITE_P(, Printing,
                         testing::Values(Walked{"product", "clearance --resume OUT",
                                                finished_calculation(small_product)}),
                         [](const auto& of) { return of.param.name; });

TEST_P(Printing, that_fails_is_reported_and_done_by_the_stated_command) {
  for (const auto& [script, why] :
       {std::pair{"echo no fonts >&2; exit 1", "no fonts"},
        {"exit 3", "without saying why"},
        {"kill -TERM $$", "by a signal"},
        {"echo %PDF-1.7", "is incomplete"},
        {"printf '%%PDF-1.7\\nstartxref\\n900\\n%%%%EOF\\n'", "is incomplete"}}) {
    const Finished child = print(script);
    EXPECT_EQ(child.status, 2) << child.err;
    EXPECT_THAT(child.err, testing::AllOf(HasSubstr("WeasyPrint could not print product.html"),
                                          HasSubstr(why), HasSubstr("clearance --resume")));
    EXPECT_THAT(read_file(out_ / "run.json"), HasSubstr("\"stopped\""));
    EXPECT_FALSE(fs::exists(pdf_));
    path_.put(a_pdf_);
    succeeding({"clearance", "--resume", out_.string()});
    EXPECT_THAT(read_file(pdf_), testing::EndsWith("%%EOF\n"));
  }
  fs::remove(pdf_);  // and again where it is gone
  succeeding({"clearance", "--resume", out_.string()});
  EXPECT_TRUE(fs::exists(pdf_));
}

// As of a terminal or mpirun, to all processes of the group.
TEST_P(Printing, that_a_signal_ends_stops_the_calculation) {
  for (const char* signal : {"INT", "TERM", "HUP", "USR1"}) {
    const Finished child =
        print("kill -" + std::string(signal) + " $PPID; kill -" + std::string(signal) + " $$");
    EXPECT_EQ(child.status, 75) << child.err;
    EXPECT_THAT(child.err, testing::AllOf(HasSubstr("stopped by SIG" + std::string(signal)),
                                          HasSubstr("clearance --resume")));
    path_.put(a_pdf_);
    succeeding({"clearance", "--resume", out_.string()});
    EXPECT_TRUE(fs::exists(pdf_));
  }
}

TEST_P(Printing, into_a_folder_that_is_not_utf8_is_like_others) {
  prepare();
  path_.put(a_pdf_);
  const fs::path other = out_.string() + "\377";
  fs::remove_all(other);
  fs::rename(out_, other);
  EXPECT_EQ(run_program({"clearance", "--resume", other.string()}).status, 0);
  EXPECT_TRUE(fs::exists(other / "product.pdf"));
}

TEST_P(Printing, into_a_folder_that_is_removed_meanwhile_is_reported) {
  const Finished child = print("/bin/rm -r " + in_quotes(out_) + "; " + a_pdf_);
  EXPECT_EQ(child.status, 2) << child.err;
  EXPECT_THAT(child.err, HasSubstr("was removed or moved"));
}

// That of a browser, say.
TEST_P(Printing, does_not_write_over_a_pdf_of_the_user) {
  prepare();
  path_.put(a_pdf_);
  write_input(pdf_, "mine");
  expect_refused(run_shell(line()), {"product.pdf", "does not list it", "move it away"});
  EXPECT_EQ(read_file(pdf_), "mine");
}

}  // namespace
}  // namespace glissade::test
