// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/io/journal.hpp"

#include <gmock/gmock.h>

#include <atomic>
#include <thread>

#include "glissade/core/bytes.hpp"
#include "glissade/core/file.hpp"
#include "glissade/core/hash.hpp"
#include "glissade/study/run/exchange.hpp"
#include "unit/io/journal_plan.hpp"
#include "unit/io/problems.hpp"
#include "unit/io/temporary_folder.hpp"

namespace glissade {
namespace {

namespace fs = std::filesystem;
using test::journal_plan;
using test::journal_unit;
using test::states;

class JournalTest : public testing::Test {
 protected:
  JournalTest() { fs::create_directory(folder_.path() / "journal"); }
  void write(int rank, const std::vector<std::uint64_t>& units) const {
    JournalWriter writer(folder_.path(), rank, run_);
    for (const std::uint64_t unit : units) writer.append(journal_unit(plan_, unit));
    writer.sync();
  }
  /// The units that are read, each of which has the bits that were written.
  std::vector<std::uint64_t> read_units() {
    std::vector<std::uint64_t> units;
    bytes_not_read_ = read_journals(folder_.path(), run_, plan_, [&](const UnitResult& unit) {
      EXPECT_EQ(pack(unit), pack(journal_unit(plan_, unit.unit)));
      units.push_back(unit.unit);
    });
    return units;
  }
  fs::path file(const std::string& name) const { return folder_.path() / "journal" / name; }
  void replace(const std::string& name, const std::string& bytes) const {
    folder_.write("journal/" + name, bytes);
  }

  TemporaryFolder folder_;
  Plan plan_ = journal_plan();
  RunIdentity run_ = identity_of(plan_, "1.2.3");
  std::uint64_t bytes_not_read_ = 0;  ///< by the last read_units()
};

TEST_F(JournalTest, a_writer_reads_back_what_it_wrote_also_in_turn) {
  JournalWriter writer(folder_.path(), 0, run_);
  const auto append = [&](std::uint64_t unit) { writer.append(journal_unit(plan_, unit)); };
  const auto expect = [&](std::uint64_t unit) {
    EXPECT_EQ(writer.read_next(), pack(journal_unit(plan_, unit))) << unit;
  };
  append(1);
  append(0);
  expect(1);
  append(2);
  expect(0);
  expect(2);
  append(1);
  expect(1);
}

TEST_F(JournalTest, what_two_ranks_and_two_sessions_wrote_is_read_once_to_the_last_bit) {
  write(0, {0});
  write(1, {2});
  write(0, {1, 2});
  EXPECT_TRUE(fs::exists(file("0-2.units")));
  EXPECT_THAT(read_units(), testing::UnorderedElementsAre(0, 1, 2));
  EXPECT_EQ(bytes_not_read_, 0u);
}

TEST_F(JournalTest, a_file_cut_at_any_byte_is_read_to_its_last_whole_record) {
  write(0, {0});
  const std::size_t one = fs::file_size(file("0-1.units"));
  write(1, {0, 1});
  const std::string bytes = read_text_file(file("1-1.units"));
  fs::remove(file("0-1.units"));
  for (std::size_t size = 0; size <= bytes.size(); ++size) {
    replace("1-1.units", bytes.substr(0, size));
    const std::size_t whole = size < one ? 0 : size < bytes.size() ? 1 : 2;
    EXPECT_EQ(read_units().size(), whole) << size;
    if (whole > 0) {
      EXPECT_EQ(bytes_not_read_, whole == 1 ? size - one : 0u) << size;
    }
  }
}

TEST_F(JournalTest, a_flipped_bit_anywhere_is_found) {
  write(0, {0, 1});
  const std::string bytes = read_text_file(file("0-1.units"));
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    std::string flipped = bytes;
    flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ (1 << bit % 8));
    replace("0-1.units", flipped);
    EXPECT_LT(read_units().size(), 2u) << bit;  // and what is read has the right bits
    EXPECT_GT(bytes_not_read_, 0u) << bit;
  }
}

TEST_F(JournalTest, a_length_beyond_the_file_or_a_unit_is_not_believed) {
  write(0, {0});
  const std::string bytes = read_text_file(file("0-1.units"));
  for (const std::uint64_t size : {std::uint64_t{1} << 62, std::uint64_t{1} << 30}) {
    const std::vector<char> head = ByteWriter().put(size).put(std::uint64_t{0}).take();
    replace("0-1.units", bytes + std::string(head.begin(), head.end()));
    fs::resize_file(file("0-1.units"), std::uint64_t{1} << 31);  // sparse
    EXPECT_EQ(read_units(), std::vector<std::uint64_t>{0});
  }
}

TEST_F(JournalTest, one_damaged_record_does_not_hide_the_others) {
  write(0, {0, 1, 2});
  std::string bytes = read_text_file(file("0-1.units"));
  const std::size_t of_last = pack(journal_unit(plan_, 2)).size() + 16,
                    of_middle = pack(journal_unit(plan_, 1)).size() + 16;
  bytes[bytes.size() - of_last - 8] ^= 1;
  replace("0-1.units", bytes);
  EXPECT_THAT(read_units(), testing::ElementsAre(0, 2));
  EXPECT_EQ(bytes_not_read_, of_middle);
}

TEST_F(JournalTest, a_record_that_does_not_fit_the_plan_is_not_read) {
  for (int fault = 0; fault < 4; ++fault) {
    JournalWriter writer(folder_.path(), 0, run_);
    UnitResult unit = journal_unit(plan_, 1);
    if (fault == 0) unit.unit = 3;
    if (fault == 1) unit.fields.uplift.pop_back();
    if (fault == 2) unit.fields.shear_along.assign(2, 0.0);
    if (fault == 3) unit.fields.capacity.clear();
    writer.append(unit);
    EXPECT_TRUE(read_units().empty()) << fault;
  }
}

TEST_F(JournalTest, the_journal_of_another_run_is_refused) {
  const RunIdentity mine = run_;
  for (int difference = 0; difference < 3; ++difference) {
    run_ = mine;
    if (difference == 0) run_.program_version = "1.2.4";
    if (difference == 1) run_.plan_hash = "other";
    if (difference == 2) run_.layout = "other";
    write(0, {0});
    run_ = mine;
    EXPECT_THAT(message_of([&] { read_units(); }), states("0-1.units")) << difference;
    fs::remove(file("0-1.units"));
  }
}

TEST_F(JournalTest, every_difference_of_two_runs_is_named) {
  RunIdentity now = run_;
  const auto message = [&] {
    return message_of([&] { check_same_run(run_, now, folder_.path()); });
  };
  EXPECT_EQ(message(), "");
  now.plan_hash = "fedcba9876543210";
  EXPECT_THAT(message(), states("fedcba9876543210"));
  now.program_version = "1.2.4";
  now.study_text = "[study]\nname = \"a\"\nseed = 2\n";
  EXPECT_THAT(message(), states("1.2.3", "1.2.4", "study.toml:3", "\"seed = 2\"", "\"seed = 1\""));
  now.study_text = run_.study_text + "more\n";
  EXPECT_THAT(message(), states("study.toml:4"));
  now = run_;
  run_.motions_text = "a suite.toml, target 0a\na suite.toml, motion X 1f\n";
  now.motions_text = "a suite.toml, target 0a\na suite.toml, motion X 2f\n";
  EXPECT_THAT(message(), states("suite.toml, motion X"));
  now.motions_text = "a suite.toml, target 0a\na suite.toml, motion Y 1f\n";
  EXPECT_THAT(message(), states("suite.toml, motion X", "suite.toml, motion Y"));
  now.mathematics = "other";  // of which other motions are a consequence
  EXPECT_THAT(message(), states("another kind of processor", "resume it on a machine of the kind"));
  EXPECT_EQ(message().find("motion"), std::string::npos);
  now = run_;
  now.layout = "other";
  EXPECT_NE(message(), "");
}

TEST_F(JournalTest, what_a_run_rests_on_is_read_as_it_was_written_or_refused) {
  EXPECT_FALSE(has_identity(folder_.path()));
  EXPECT_THAT(message_of([&] { read_identity(folder_.path()); }), states("no run"));
  write_identity(folder_.path(), run_);
  EXPECT_EQ(message_of([&] { check_same_run(run_, read_identity(folder_.path()), ""); }), "");
  EXPECT_EQ(read_identity(folder_.path()).study_file, run_.study_file);
  const std::string bytes = read_text_file(file("run"));
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    replace("run", bytes.substr(0, size));
    EXPECT_THAT(message_of([&] { read_identity(folder_.path()); }), states("damaged")) << size;
  }
}

TEST_F(JournalTest, a_folder_has_units_from_the_first_record_on) {
  EXPECT_FALSE(has_units(folder_.path()));
  write(0, {1});
  EXPECT_TRUE(has_units(folder_.path()));
  const std::uint64_t record = 16 + pack(journal_unit(plan_, 1)).size();
  fs::resize_file(file("0-1.units"), fs::file_size(file("0-1.units")) - record);
  EXPECT_FALSE(has_units(folder_.path()));
}

TEST_F(JournalTest, two_runs_cannot_hold_one_folder) {
  EXPECT_FALSE(is_running(folder_.path()));
  {
    RunLock lock(folder_.path());
    EXPECT_TRUE(is_running(folder_.path()));
    EXPECT_EQ(problems_of([&] { RunLock second(folder_.path()); }).size(), 1u);
    write(0, {1});
    lock.remove_journals();
    EXPECT_FALSE(fs::exists(folder_.path() / "journal"));
  }
  RunLock again(folder_.path());
  EXPECT_TRUE(is_running(folder_.path()));
}

TEST_F(JournalTest, a_run_that_begins_while_another_process_asks_for_one_is_not_refused) {
  std::atomic<bool> ends = false;
  std::atomic<int> asked = 0;
  std::thread other([&] {
    for (; !ends; ++asked) is_running(folder_.path());
  });
  for (int i = 0; i < 2000 || asked < 2000; ++i) EXPECT_NO_THROW(RunLock lock(folder_.path())) << i;
  ends = true;
  other.join();
}

TEST_F(JournalTest, a_lock_leaves_nothing_where_no_run_began) {
  { const RunLock lock(folder_.path()); }
  EXPECT_FALSE(fs::exists(folder_.path() / "journal"));
  {
    const RunLock lock(folder_.path());
    write_identity(folder_.path(), run_);
  }
  EXPECT_TRUE(has_identity(folder_.path()));
}

TEST_F(JournalTest, a_folder_that_cannot_be_written_is_one_error) {
  JournalWriter writer(folder_.path() / "missing", 0, run_);
  EXPECT_THAT(message_of([&] { writer.append(journal_unit(plan_, 0)); }), states("0-1.units"));
}

}  // namespace
}  // namespace glissade
