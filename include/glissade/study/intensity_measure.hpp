// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "glissade/motion/motion.hpp"
#include "glissade/motion/scaling_rule.hpp"

namespace glissade {

struct IntensityConfig;

/// What the levels of a study mean: a row of the table in src/study/intensity_measure.cpp, which is
/// all that an intensity measure is made of. Record i at level x runs with the factor that gives it
/// that intensity.
class IntensityMeasure {
 public:
  /// Those that the code names; all are found by key.
  static const IntensityMeasure sds_g, ppa_g, mce_fraction, pga_g, sa_g, avg_sa_g, factor;
  static std::size_t count();
  static IntensityMeasure number(std::size_t row) { return IntensityMeasure(row); }
  static std::optional<IntensityMeasure> named(const std::string& key);

  const char* key() const;      ///< "pga_g": in study and results files
  const char* unit() const;     ///< "g", "m/s", "-"
  std::string meaning() const;  ///< in a sentence, with its definition
  /// The key of [intensity] of this measure only; null: none.
  const char* own_key() const;
  /// In sentences: "S_DS", "Sa(1 s)".
  std::string symbol(const IntensityConfig& intensity) const;
  /// For axes and titles: "Sa(1 s), geometric mean of both horizontals, 5 %".
  std::string definition(const IntensityConfig& intensity) const;
  /// One factor on each record at level 1; 0 where it depends on the roof. All
  /// of one suite.
  /// @param spectra of the suite's motions by the rule of `intensity`, of sds_g
  std::vector<double> factors_at_unit_level(const IntensityConfig& intensity, const Suite& suite,
                                            const SpectraByRule& spectra) const;
  /// The factor on a record at a level over that at level 1: the level, or its
  /// root for measures that go with a power of the motion.
  double factor_of_level(double level) const;

  /// Scales the suite to a design spectrum: sds_g and mce_fraction.
  bool is_of_design_spectrum() const { return *this == sds_g || *this == mce_fraction; }

  bool operator==(const IntensityMeasure&) const = default;

 private:
  constexpr explicit IntensityMeasure(std::size_t row) : row_(row) {}
  std::size_t row_;
};
inline constexpr IntensityMeasure IntensityMeasure::sds_g{0};
inline constexpr IntensityMeasure IntensityMeasure::ppa_g{1};
inline constexpr IntensityMeasure IntensityMeasure::mce_fraction{2};
inline constexpr IntensityMeasure IntensityMeasure::pga_g{3};
inline constexpr IntensityMeasure IntensityMeasure::sa_g{4};
inline constexpr IntensityMeasure IntensityMeasure::avg_sa_g{5};
inline constexpr IntensityMeasure IntensityMeasure::factor{8};

/// "_g", "_mps", "": what the name of a column or dataset in this unit ends with.
std::string unit_suffix(const std::string& unit);

}  // namespace glissade
