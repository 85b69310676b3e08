// SPDX-License-Identifier: GPL-3.0-or-later
// The samples of each format, against their index, which was made with other readers.
#include <cmath>
#include <fstream>

#include "glissade/io/record_file.hpp"
#include "problems.hpp"
#include "recorded_motions.hpp"
#include "text/csv_rows.hpp"
#include "text/scan.hpp"

namespace glissade {
namespace {

namespace fs = std::filesystem;

/// A row of INDEX.csv; what it leaves empty is 0.
struct Indexed {
  std::string file, units;
  double npts = 0.0, dt_s = 0.0, pga_g = 0.0;
};

/// Steps of COSMOS files, by the time that their text lines state of the peak, for which the index
/// has that of the recorder: sample 2785 at 27.850 s, sample 15243 at 76.215 s.
double step_by_peak_s(const std::string& file, double indexed_s) {
  if (file.find("Cosmos12TimeSeriesTest") != std::string::npos) return 27.850 / 2785;
  return file.find("akbmrp") != std::string::npos ? 76.215 / 15243 : indexed_s;
}

std::vector<Indexed> indexed_formats() {
  std::vector<Indexed> rows;
  std::ifstream in(folder_of_records() / "INDEX.csv");
  const auto number = [](std::string_view text) { return parse_number(text).value_or(0.0); };
  for (std::string line; std::getline(in, line);) {
    const auto cells = quoted_cells(line, ',');
    if (cells.size() > 7 && cells[0].starts_with("formats/"))
      rows.push_back({std::string(cells[0]), std::string(cells[7]), number(cells[4]),
                      step_by_peak_s(std::string(cells[0]), number(cells[5])), number(cells[6])});
  }
  return rows;
}

/// The units that the index states of a file which does not; those it guesses are any.
AccelerationUnits units_asked_for(const Indexed& row) {
  if (row.units.starts_with("g")) return AccelerationUnits::g;
  return row.units.starts_with("m/s") ? AccelerationUnits::mps2 : AccelerationUnits::cmps2;
}

/// Gives what the reader asks for, by its message, until it reads.
Record read_as_asked(const Indexed& row, RecordFileOptions& options) {
  for (int asked = 0;; ++asked) {
    try {
      return read_record(folder_of_records() / row.file, options);
    } catch (const InputError& error) {
      const std::string message = error.what();
      const auto says = [&](const char* text) { return message.find(text) != std::string::npos; };
      if (asked < 4 && says("components: #1")) {
        options.component = "1";
      } else if (asked < 4 && says("counts_per_unit")) {
        options.units = AccelerationUnits::mps2;
        options.counts_per_unit = 1e9;
      } else if (asked < 4 && says("give units")) {
        options.units = units_asked_for(row);
      } else if (asked < 4 && says("does not give the time step")) {
        options.dt_s = 0.01;
      } else {
        throw;
      }
    }
  }
}

/// The index has the peak of one component, or of all.
bool any_component_peaks_at(const Indexed& row, RecordFileOptions options) {
  for (const char* component : {"1", "2", "3"}) {
    if (!options.component.empty()) options.component = component;
    if (std::abs(peak_g(read_record(folder_of_records() / row.file, options).acceleration_mps2) -
                 row.pga_g) < 6e-5)
      return true;
    if (options.component.empty()) break;
  }
  return false;
}

/// What is no motion, or none that can be read, and what is said of it.
struct RefusedSample {
  const char *part, *fact;
};
constexpr RefusedSample refused_samples[] = {{"usc_dat/", "where the step is"},
                                             {"CE89146.V3", "spectra"},
                                             {"16882.metadata", "is not a number"},
                                             {"ground_motion_set.csv", "no column"},
                                             {"fullseed.mseed", "SEED"},
                                             {"gaps.mseed", "gap"},
                                             {"Endian.mseed", "seismometer"},
                                             {"steim2.mseed", "seismometer"},
                                             {"/test.mseed", "seismometer"},
                                             {"two_channels.mseed", "seismometer"},
                                             {"CE.79435.xml", "StationXML"},
                                             {"testxy.sac", "SAC as text"},
                                             {"g3_headerless_5col", "5 columns"}};

class RecordedFormats : public RecordedMotions {};

TEST_F(RecordedFormats, every_sample_is_read_as_its_index_says_or_is_refused_by_name) {
  std::size_t read = 0;
  for (const Indexed& row : indexed_formats()) {
    RecordFileOptions options;
    const auto refused = std::ranges::find_if(refused_samples, [&](const RefusedSample& sample) {
      return row.file.find(sample.part) != std::string::npos;
    });
    if (refused != std::end(refused_samples)) {
      EXPECT_THAT(message_of([&] { read_as_asked(row, options); }),
                  testing::HasSubstr(refused->fact))
          << row.file;
      continue;
    }
    try {
      const Record record = read_as_asked(row, options);
      ++read;
      if (row.npts > 0.0) {
        EXPECT_EQ(record.acceleration_mps2.size(), static_cast<std::size_t>(row.npts)) << row.file;
      }
      if (row.dt_s > 0.0) {
        EXPECT_NEAR(record.dt_s, row.dt_s, 1e-12) << row.file;
      }
      if (row.pga_g > 0.0) {
        EXPECT_TRUE(any_component_peaks_at(row, options)) << row.file;
      }
    } catch (const InputError& error) {
      ADD_FAILURE() << row.file << ": " << error.what();
    }
  }
  EXPECT_GE(read, 80u);
}

// From ../shared/faults: as users exported them, or made up.
TEST_F(RecordedFormats, exports_of_programs_are_read_as_they_are) {
  const fs::path faults = folder_of_records().parent_path() / "faults";
  if (!fs::is_directory(faults)) GTEST_SKIP() << "no folder faults beside the records";
  const RecordFileOptions none, mps2{.dt_s = {}, .units = AccelerationUnits::mps2},
      g{.dt_s = {}, .units = AccelerationUnits::g};
  struct Export {
    const char *file, *component;
    RecordFileOptions options;
    std::size_t samples;
  };
  for (const Export& e : {Export{"etabs.csv", "", none, 2000},
                          {"csv_header_one_line.csv", "", none, 2000},
                          {"kn.csv", "", none, 2000},
                          {"semicolon_de.csv", "", g, 2000},
                          {"sap_tab.txt", "U1", none, 2000},
                          {"opensees_3col.out", "3", mps2, 2000},
                          {"dexp.AT2", "", none, 2000},
                          {"touch.AT2", "", none, 2000},
                          {"dt_rounded.txt", "", g, 2000},
                          {"record_semicolon.csv", "", g, 40},
                          {"record_decimal_comma.csv", "", g, 40},
                          {"floor.csv", "ay", none, 1499}}) {
    RecordFileOptions options = e.options;
    options.component = e.component;
    try {
      EXPECT_EQ(read_record(faults / e.file, options).acceleration_mps2.size(), e.samples)
          << e.file;
    } catch (const InputError& error) {
      ADD_FAILURE() << e.file << ": " << error.what();
    }
  }
  EXPECT_THAT(message_of([&] { read_record(faults / "floor.csv"); }),
              test::states("#1 (ax)", "#2 (ay)", "#3 (az)"));
}

}  // namespace
}  // namespace glissade
