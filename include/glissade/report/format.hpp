// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glissade/core/units.hpp"
#include "glissade/fragility/fit.hpp"
#include "glissade/report/table.hpp"
#include "glissade/standards/prescriptive.hpp"
#include "glissade/study/config.hpp"
#include "glissade/study/plan/skip.hpp"

namespace glissade {

/// To significant digits: the double that is nearest to the decimal number. Of any size, where
/// std::stod refuses a subnormal one.
double rounded_to(double value, int digits);
/// Three significant digits and no exponent where one can be avoided: "0.300", "12.5", "1024"; "-"
/// for what is not finite.
std::string format_number(double value);
/// Of annual rates: "1.6e-4".
std::string format_rate(double annual_rate);
/// The shortest text that reads back as the same double; "" for NaN (an empty CSV field), "inf",
/// "-inf".
std::string format_exact(double value);
/// Which unit stands first in the texts, tables and figures that are made while this lives: one
/// report at a time.
class LengthUnits {
 public:
  explicit LengthUnits(UnitSystem units);
  ~LengthUnits();
  LengthUnits(const LengthUnits&) = delete;
  LengthUnits& operator=(const LengthUnits&) = delete;
  static UnitSystem first();  ///< metres where none lives

 private:
  UnitSystem before_;
};
/// "0.300 m (11.8 in)", or "11.8 in (0.300 m)"; "-" for what is not finite.
std::string format_length(double length_m);
/// "0.300", "11.8": three significant digits, at most 0.1 mm or 0.001 in; "< 0.001" and "< 0.02"
/// below 0.5 mm.
std::string length_number(double length_m, UnitSystem units);
/// "0.300 m", or "11.8 in".
std::string short_length(double length_m);
/// "0.276 to 0.393 m", "10.9 to 15.5 in"; "no interval" where an end is NaN.
std::string format_length_interval(const Interval& interval_m);
/// In the unit that stands first.
double in_first_unit(double length_m);
/// "12 %", "0.4 %", "< 0.1 %", "0 %"; "-" for what is not finite.
std::string format_share(double share);
/// "0.76 to 0.93"; "no interval" where an end is NaN.
std::string format_interval(const Interval& interval);
/// " (95 % interval 8.1 % to 17 %)" of a share; "" where an end is NaN.
std::string in_brackets(const Interval& of_share);
/// "p = 0.12"; "p <= 0.005" of the least that a goodness of fit can have.
std::string format_p(double p_value);
/// The same as a cell of a table: "0.12", "<= 0.005".
NumberCell p_cell(double p_value);

/// That so few records, or events, leave the interval of the 84th percentile open; "" of more.
std::string open_percentile(std::size_t units, const std::string& name = "records");

/// "SEAOC PV1-2012", "ASCE 7-16".
std::string standard_name(Standard standard);
/// "checked", "recalled".
std::string provenance_name(Provenance provenance);
/// "checked", or "recalled: verify against the standard".
std::string provenance_label(Provenance provenance);
/// " (recalled: verify against the standard)"; "" of what was checked.
std::string recalled_in_brackets(Provenance provenance);

/// "1234 histories ...: why"; without the number where nothing was counted.
std::string format_skip(const Skip& skip);

/// "Building period" of "building period"; the name of a key ("suite.file") stays as it is.
std::string capitalised(std::string text);
std::vector<std::string> capitalised(std::vector<std::string> texts);

/// A paragraph for the terminal, indented, in lines of at most 80 characters.
std::string wrapped(const std::string& text);
std::string paragraphs(const std::vector<std::string>& texts);

}  // namespace glissade
