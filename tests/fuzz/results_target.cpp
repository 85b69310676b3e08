// SPDX-License-Identifier: GPL-3.0-or-later
// Results files: small good ones, of a fragility and of every analysis on two axes, edited as the
// input says (results_edit.hpp). What is then still read must be whole and writable, to a file that
// reads as the same bytes, and a report can be made of it.
#include <algorithm>
#include <array>
#include <optional>

#include "check.hpp"
#include "results_edit.hpp"
#include "unit/io/renew_checksum.hpp"
#include "unit/io/run_results.hpp"
#include "unit/io/whole_report.hpp"

namespace {

using namespace glissade;
using fuzz::check;

void check_whole(const Results& results) {
  const HistoryTable& table = results.histories;
  check(table.records == results.records.size() && table.cases == results.cases.size() &&
            table.levels == results.levels.size() &&
            table.thresholds == results.thresholds_m.size(),
        "histories fit the records, cases, levels and thresholds");
  for_each_history_field([&](auto field) {
    const std::size_t size = (table.fields.*field.of).size();
    check(size == 0 || size == table.records * table.cases * table.depth(field.depth),
          "a field has a value for each history");
  });
  check(results.cases.combinations() * results.cases.per_combination() == results.cases.size(),
        "cases are every combination");
  for (const RunResults& run : results.runs) {
    check(run.first_case + run.cases <= results.cases.size(), "a run's cases are there");
    check(run.slip.size() == results.levels.size(), "slip at each level");
    check(run.fragilities.size() == results.thresholds_m.size(), "a fragility for each threshold");
    for (const ThresholdFragility& f : run.fragilities) {
      check(f.probability.size() == results.levels.size() &&
                f.probability_interval.size() == results.levels.size(),
            "a share for each level");
    }
  }
}

struct GoodFile {
  std::string bytes;
  std::vector<std::string> names;  ///< of its objects
};

GoodFile good_file(const Results& results) {
  std::string bytes = test::bytes_of(results, fuzz::folder(), "good.h5");
  return {std::move(bytes), fuzz::names_in(fuzz::folder().path() / "good.h5")};
}

void edit_and_read(const GoodFile& good, const std::uint8_t* data, std::size_t size) {
  const auto file = fuzz::write_input("results.h5", good.bytes);
  {
    fuzz::ResultsEditor editor(file, good.names);
    fuzz::Bytes bytes(data, std::min<std::size_t>(size, 4096));
    while (bytes.left() > 0) editor.edit(bytes);
  }
  test::renew_checksum(file);
  std::optional<Results> results;
  fuzz::may_refuse([&] { results = read_results(file); });
  if (!results) return;
  check_whole(*results);
  const std::string copy = test::bytes_of(*results, fuzz::folder(), "copy.h5");
  const Results read = read_results(fuzz::folder().path() / "copy.h5");
  check(copy == test::bytes_of(read, fuzz::folder(), "second.h5"), "results survive their file");
  const WholeReport report = report_of(*results);
  for (const std::string& table : report.tables) check(!table.empty(), "tables are written");
  check(!report.page.empty(), "a page is made");
  check(!report.summary.empty(), "a summary is made");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const bool silent = H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr) >= 0;
  check(silent, "HDF5 prints nothing");
  static const std::array good = {good_file(test::with_everything()),
                                  good_file(test::results_of(test::study_of_means))};
  for (const GoodFile& file : good) edit_and_read(file, data, size);
  return 0;
}
