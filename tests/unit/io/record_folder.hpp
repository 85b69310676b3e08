// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <string>
#include <vector>

#include "glissade/io/suite_file.hpp"
#include "glissade/io/suite_import.hpp"
#include "problems.hpp"
#include "temporary_folder.hpp"

namespace glissade {

/// A made-up motion; each seed another.
inline std::vector<double> motion_g(double seed, std::size_t count = 200) {
  std::vector<double> a;
  for (std::size_t i = 0; i < count; ++i) {
    const double t = 0.01 * static_cast<double>(i);
    a.push_back(0.3 * std::sin(3.0 * t) * std::sin((20.0 + seed) * t + seed));
  }
  return a;
}

inline std::string lines_of_samples(const std::vector<double>& a) {
  std::string text;
  for (const double value : a) text += fmt::format("{:.9f}\n", value);
  return text;
}

/// A file of NGA-West2.
inline std::string at2(const std::string& source, double seed, std::size_t count = 200,
                       double dt_s = 0.01) {
  return fmt::format(
             "PEER NGA STRONG MOTION DATABASE RECORD\n{}\nACCELERATION TIME SERIES IN UNITS OF G\n"
             "NPTS=   {}, DT=   {:.4f} SEC\n",
             source, count, dt_s) +
         lines_of_samples(motion_g(seed, count));
}

inline std::string column(double seed, std::size_t count = 200, double dt_s = 0.01) {
  return fmt::format("# units: g\n# DT = {}\n", dt_s) + lines_of_samples(motion_g(seed, count));
}

/// A file of CSMIP or CESMD with one channel.
inline std::string csmip_v2(const std::string& channel, double seed, std::size_t count = 200) {
  std::string text = fmt::format(
      "Corrected accelerogram\nUncorrected Accelerogram Data\nRecord of Jan 1, 2020\n"
      "Station No. 00001   30.000N, 100.000W\nSome Hall\n{}\n"
      "{:5} points of accel data equally spaced at  .010 sec, in cm/sec2. (8f10.3)\n",
      channel, count);
  const std::vector<double> a = motion_g(seed, count);
  for (std::size_t i = 0; i < count; ++i)
    text += fmt::format("{:10.3f}{}", 980.665 * a[i], i % 8 == 7 || i + 1 == count ? "\n" : "");
  return text;
}

/// Options that take directions from names.
inline ImportOptions by_names() {
  ImportOptions options;
  options.directions_from_names = true;
  return options;
}

/// Why files are left out, a line each.
inline std::string reasons(const SuiteImport& found) {
  std::string text;
  for (const LeftOut& left : found.left_out) text += left.what + ": " + left.reason + "\n";
  return text;
}

/// A folder of record files, and the suite that is made of it.
class SuiteImporter : public testing::Test {
 protected:
  SuiteImport import(ImportOptions options = {}) const {
    options.inputs = {folder_.path() / "records"};
    return import_suite(options);
  }
  void write(const std::string& name, const std::string& text) const {
    folder_.write("records/" + name, text);
  }
  SuiteImport import_with_report(const std::string& report) const {
    ImportOptions options;
    options.report = folder_.write("report.csv", report);
    return import(options);
  }
  /// The suite that is written beside the folder, read.
  Suite load(const SuiteImport& found) const {
    return load_suite(
        folder_.write("suite.toml", imported_suite_toml(found, {"s", {}, {}}, folder_.path())));
  }
  /// "first, second, vertical" by their files.
  static std::string files_of(const SuiteImport& found, const ImportedRecord& record) {
    std::string list;
    for (const auto& component : record.components)
      list += (list.empty() ? "" : ", ") +
              (component ? found.components[*component].shown() : std::string("-"));
    return list;
  }
  void write_triple(const std::string& source = "Somewhere, 1/2/1999, Place") const {
    write("RSN7_SOME_PLC000.AT2", at2(source + ", 0", 1));
    write("RSN7_SOME_PLC090.AT2", at2(source + ", 90", 2));
    write("RSN7_SOME_PLC-UP.AT2", at2(source + ", UP", 3));
  }
  TemporaryFolder folder_;
};

}  // namespace glissade
