// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <initializer_list>
#include <limits>
#include <string>
#include <vector>

namespace glissade::verification {

/// What the reference of a case rests on. What rests on this code alone shows that two of its parts
/// agree, not that either is right: such cases are in a chapter of their own.
enum class ReferenceFrom { outside, this_code };

/// What a case is about, in words.
struct Subject {
  std::string name;      ///< "trapezoidal pulse on a flat roof"
  std::string quantity;  ///< "peak slip, m"
  std::string source;    ///< where the reference comes from
  ReferenceFrom from = ReferenceFrom::outside;
};

/// One row of cases.csv.
struct Case {
  std::string name, quantity, reference, metric, tolerance;
  std::string result;  ///< the only column in which two machines may differ
  bool pass = false;
  ReferenceFrom from = ReferenceFrom::outside;
  /// Difference over tolerance; NaN where the tolerance is a range, or zero.
  double of_tolerance = std::numeric_limits<double>::quiet_NaN();
};

enum class Metric { absolute, relative };

struct Comparison {
  double value, expected, tolerance;
  Metric metric = Metric::relative;
};
/// A number against a number: |value - expected| <= tolerance, or |value / expected - 1| <=
/// tolerance.
Case compare(const Subject& subject, const Comparison& comparison);

struct Number {
  std::string quantity;
  Comparison comparison;
};
/// Several of one name and source.
std::vector<Case> compare_all(const std::string& name, const std::string& source,
                              std::initializer_list<Number> numbers);

struct Bound {
  std::string metric;  ///< what `value` is: "largest relative difference of 480 histories"
  double value, at_most;
};
/// A measured difference against its limit, where the reference is not one number.
Case limit(const Subject& subject, const Bound& bound);

struct Range {
  std::string metric;
  double value, low, high;
};
Case within(const Subject& subject, const Range& range);

struct Mismatches {
  int differing, of;
};
/// Results that must be equal to the last bit, or statements that must hold.
Case all_equal(const Subject& subject, const Mismatches& mismatches);

/// The larger of two differences; NaN if one of them is, so that no difference is lost.
double worse(double a, double b);

std::vector<Case> joined(std::initializer_list<std::vector<Case>> parts);

/// A statement of one of the two papers beside what is computed here.
struct Finding {
  std::string paper, here, confirmed;
};

/// "yes" or "no".
std::string yes(bool confirmed);

/// A table that is too long for the page.
struct CsvFile {
  std::string name, text;
};

/// A part of the manual: text, its cases and, below it, measured tables (in Markdown) and figures.
struct Chapter {
  std::string title;
  std::string reference;  ///< the most important one, in a few words
  std::string text;
  std::vector<Case> cases;
  std::string figures = {};
  std::string measured = {};  ///< its numbers may differ on another machine
  std::vector<Finding> findings = {};
  std::vector<CsvFile> files = {};  ///< numbers of two decimals
};

/// Where chapters find their inputs and leave their figures.
struct Folders {
  std::filesystem::path suites;  ///< the built-in suites
  std::filesystem::path studies;
  std::filesystem::path simulation;  ///< what verify_simulation wrote
  std::filesystem::path figures;
};

}  // namespace glissade::verification
