// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/io/mode_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "glissade/building/mode_rules.hpp"
#include "glissade/core/error.hpp"
#include "text/csv_rows.hpp"
#include "text/scan.hpp"

namespace glissade {
namespace {

constexpr const char* add_participation =
    "add a column participation, at the array, or factor and roof_shape: the UX (or UY) of the "
    "table Modal Participation Factors and the U1 (or U2) of a joint at the array in Joint "
    "Displacements of the modal case, both of one normalisation; their product is the "
    "participation (suites/README.md)";

/// Modes as they are read, checked one by one.
class ModeList {
 public:
  RowTrouble add(const Mode& mode) {
    if (!(mode.period_s > 0.0 && std::isfinite(mode.period_s)))
      return {"the period is not above 0 and finite"};
    if (!modes_.empty() && mode.period_s > modes_.back().period_s)
      return {"periods must fall from row to row"};
    if (!(mode.mass_share >= 0.0 && mode.mass_share <= 1.0))
      return {"the mass share is not from 0 to 1", "91 % is 0.91 or \"91 %\""};
    if (!(std::abs(mode.participation) <= most_participation))
      return {fmt::format("the participation is not from -{0:g} to {0:g}", most_participation)};
    if (!(mode.damping_ratio >= 0.0 && mode.damping_ratio <= most_mode_damping))
      return {fmt::format("the damping is not from 0 to {:g}", most_mode_damping),
              "5 % is 0.05 or \"5 %\""};
    if (mode.mass_share > 0.0) modes_.push_back(mode);  // or it is of another axis
    return {};
  }
  std::vector<Mode> checked(const std::filesystem::path& file) && {
    constexpr double rounding = 1e-3;  // of shares with a few digits
    if (modes_.empty())
      throw InputError({file.string(), "has no mode with mass along the axis",
                        "check the axis and the modal case", ""});
    if (mass_of(modes_) > 1.0 + rounding)
      throw InputError(
          {file.string(),
           fmt::format("the mass shares are {:.4g} together, more than 1", mass_of(modes_)),
           "give those of one axis, each as a fraction of the building's mass", ""});
    return std::move(modes_);
  }

 private:
  std::vector<Mode> modes_;
};

/// Of the mode's number, from 0.
std::optional<double> shape_of(const ModeFileOptions& options, std::size_t number) {
  if (number >= options.roof_shape.size()) return std::nullopt;
  return options.roof_shape[number];
}

void check_axis(const std::filesystem::path& file, const ModeFileOptions& options) {
  if (!options.axis)
    throw InputError({file.string(), "has modes of both axes", "give --axis x or --axis y", ""});
}

void check_shapes(const std::filesystem::path& file, const ModeFileOptions& options,
                  std::size_t modes) {
  if (options.roof_shape.size() == modes) return;
  throw InputError({"--roof-shape",
                    fmt::format("has {} value(s), and {} has {} modes", options.roof_shape.size(),
                                file.string(), modes),
                    "give one for each mode: its displacement at the array along the axis, of the "
                    "normalisation of the participation factors (OpenSees: nodeEigenvector)",
                    ""});
}

/// A number with a decimal point or comma, and a percent sign where it is a share.
std::optional<double> number_in(std::string_view cell, bool may_be_percent) {
  std::string text(cell);
  const bool is_percent = may_be_percent && text.ends_with('%');
  if (is_percent) text = std::string(trimmed(std::string_view(text).substr(0, text.size() - 1)));
  if (std::ranges::count(text, ',') == 1 && text.find('.') == text.npos)
    std::ranges::replace(text, ',', '.');
  const std::optional<double> value = parse_number(text);
  return is_percent && value ? *value / 100.0 : value;
}

/// Separated by tabs, semicolons or commas, with or without quotes.
Cells split_cells(std::string_view line) {
  return quoted_cells(line, line.find('\t') != line.npos  ? '\t'
                            : line.find(';') != line.npos ? ';'
                                                          : ',');
}

/// "periodsec" of "Period (sec)" and "period_sec".
std::string plain_heading(std::string_view name) {
  std::string plain = lower_case(name);
  std::erase_if(
      plain, [](char c) { return std::string_view(" _()[],").find(c) != std::string_view::npos; });
  return plain;
}

/// A table with a heading, of an engineer or exported.
class ModeTable {
 public:
  explicit ModeTable(const ModeFileOptions& options) : options_(options) {}

  void take_header(const std::string& where, const Cells& names) {
    const auto refuse = [&](const std::string& what, const std::string& remedy) {
      throw InputError({where, what, remedy, ""});
    };
    std::vector<bool> is_read(names.size());
    const auto column = [&](std::initializer_list<std::string_view> known) {
      std::optional<std::size_t> found;
      for (std::size_t i = 0; i < names.size(); ++i) {
        if (std::ranges::find(known, plain_heading(names[i])) == known.end()) continue;
        is_read[i] = true;
        if (found)
          refuse(fmt::format("has the columns {} and {}, which are the same number",
                             in_quotes(names[*found]), in_quotes(names[i])),
                 "leave one of them");
        found = i;
      }
      return found;
    };
    if (column({"modalmass"}))
      refuse("is the table Modal Participation Factors, which has no mass shares",
             std::string("export Modal Participating Mass Ratios, and ") + add_participation);
    period_ = column({"period", "periods", "periodsec", "ts", "tsec"});
    share_ = column({"massshare"});
    if (!share_ && (column({"ux"}) || column({"uy"}))) {
      check_axis(where, options_);
      share_ = column({*options_.axis == ModeAxis::x ? "ux" : "uy"});
    }
    participation_ = column({"participation"});
    factor_ = column({"factor"});
    shape_ = column({"roofshape"});
    damping_ = column({"damping", "dampingratio"});
    case_ = column({"case", "outputcase"});
    for (const std::string_view name : names) {
      const std::string lower = lower_case(name);
      const bool is_damping = lower.find("damp") != lower.npos || lower == "xi" || lower == "zeta";
      if (is_damping && !damping_)
        refuse("has the column " + in_quotes(name) + ", which is not read",
               "name it damping_ratio, with ratios as 0.05, or leave it out");
    }
    std::string others;
    for (std::size_t i = 0; i < names.size(); ++i)
      if (!is_read[i]) others += (others.empty() ? "; not read: " : ", ") + in_quotes(names[i]);
    if (!period_ || !share_)
      refuse(fmt::format("has no column {}{}",
                         period_  ? "mass_share, or UX and UY"
                         : share_ ? "period_s"
                                  : "period_s and no mass_share, or UX and UY",
                         others),
             "read are period_s, or T (s) or Period; mass_share, or UX and UY; participation, or "
             "factor and roof_shape; damping_ratio, as of Modal Participating Mass Ratios of ETABS "
             "or SAP 2000");
    if (!participation_ && !(factor_ && (shape_ || !options_.roof_shape.empty())))
      refuse("has mass shares, but no participation at the array" + others, add_participation);
  }

  RowTrouble take_row(const Cells& cells) {
    const std::string unit = lower_case(cells[*period_]);
    if (rows_ == 0 && (unit == "sec" || unit == "s")) return {};  // the row of units
    if (case_ && rows_ > 0 && cells[*case_] != name_) return {"is of another modal case"};
    if (case_) name_ = cells[*case_];
    const auto number = [&](const std::optional<std::size_t>& at, bool may_be_percent = false) {
      return at ? number_in(cells[*at], may_be_percent) : std::nullopt;
    };
    const std::optional<double> period_s = number(period_), share = number(share_, true),
                                damping = number(damping_, true);
    std::optional<double> participation = number(participation_);
    if (!participation_) {
      const auto factor = number(factor_),
                 shape = shape_ ? number(shape_) : shape_of(options_, rows_);
      if (factor && (shape || !shape_)) participation = *factor * shape.value_or(0.0);
    }
    ++rows_;
    if (!period_s || !share || !participation || (damping_ && !damping))
      return {"has a cell that is not a number"};
    return modes.add({*period_s, *participation, *share, damping.value_or(Mode().damping_ratio)});
  }
  bool has_damping() const { return damping_.has_value(); }
  bool uses_roof_shape() const { return !participation_ && !shape_; }
  std::size_t rows() const { return rows_; }

  ModeList modes;

 private:
  const ModeFileOptions& options_;
  std::optional<std::size_t> period_, share_, participation_, factor_, shape_, damping_, case_;
  std::string name_;
  std::size_t rows_ = 0;
};

/// Rows of numbers of a section of the report of OpenSees, "* 9. MODAL PARTICIPATION ...".
std::vector<std::vector<double>> report_section(const std::filesystem::path& file,
                                                std::string_view text, const char* heading) {
  std::vector<std::vector<double>> rows;
  LineReader lines(text);
  bool inside = false;
  while (lines.next()) {
    if (trimmed(lines.line()).starts_with("*")) inside = lines.line().find(heading) != text.npos;
    if (!inside || trimmed(lines.line()).starts_with("*") || is_blank_or_comment(lines.line()))
      continue;
    std::vector<double>& row = rows.emplace_back();
    for (const std::string_view cell : fields(lines.line())) {
      const auto value = parse_number(cell);
      if (!value)
        throw InputError({place(file, lines.number()), in_quotes(cell) + " is not a number",
                          "give the report of modalProperties as OpenSees wrote it", ""});
      row.push_back(*value);
    }
  }
  return rows;
}

/// The report of modalProperties -file (DomainModalProperties of OpenSees).
std::vector<Mode> read_report(const TextFile& file, const ModeFileOptions& options) {
  constexpr std::size_t at_period = 4;
  const auto section = [&](const char* heading) {
    return report_section(file.path, file.text, heading);
  };
  const auto eigenvalues = section("2. EIGENVALUE ANALYSIS"),
             factors = section("6. MODAL PARTICIPATION FACTORS"),
             shares = section("9. MODAL PARTICIPATION MASS RATIOS (%)");
  check_axis(file.path, options);
  check_shapes(file.path, options, eigenvalues.size());
  const std::size_t at_axis = *options.axis == ModeAxis::x ? 1 : 2;
  constexpr std::size_t columns_of_a_plane = 4;  // mode, MX, MY, RMZ
  if (*options.axis == ModeAxis::y && !factors.empty() &&
      factors.front().size() == columns_of_a_plane)
    throw InputError({file.path.string(),
                      "is of a model of two dimensions, whose y is the vertical", "give --axis x",
                      ""});
  ModeList modes;
  for (std::size_t n = 0; n < eigenvalues.size(); ++n) {
    if (factors.size() != eigenvalues.size() || shares.size() != eigenvalues.size() ||
        eigenvalues[n].size() <= at_period || factors[n].size() <= at_axis ||
        shares[n].size() <= at_axis)
      throw InputError({file.path.string(), "is not whole: sections 2, 6 and 9 have other modes",
                        "give the report of modalProperties as OpenSees wrote it", ""});
    const RowTrouble trouble =
        modes.add({eigenvalues[n][at_period], factors[n][at_axis] * options.roof_shape[n],
                   shares[n][at_axis] / 100.0});
    if (!trouble.what.empty())
      throw InputError({fmt::format("{}, mode {}", file.path.string(), n + 1), trouble.what,
                        "check the model", ""});
  }
  return std::move(modes).checked(file.path);
}

/// Without a first line "TABLE:  Modal Participating Mass Ratios"; lines keep their numbers.
TextFile without_title(TextFile file) {
  const std::size_t end = file.text.find('\n');
  if (end != file.text.npos && lower_case(file.text.substr(0, end)).find("table:") < 4)
    file.text.insert(0, "# ");
  return file;
}

}  // namespace

ModeFile read_modes(const std::filesystem::path& path, const ModeFileOptions& options) {
  const TextFile file = without_title(path);
  if (file.text.find("EIGENVALUE ANALYSIS") != file.text.npos) return {read_report(file, options)};
  ModeTable table(options);
  read_csv(file,
           {.split = split_cells,
            .begin_with = "period_s,participation,mass_share and give a row for each mode",
            .take_header =
                [&](const std::string& where, std::string_view, const Cells& names) {
                  table.take_header(where, names);
                  return true;
                },
            .take_row = [&](const Cells& cells, std::size_t) { return table.take_row(cells); }});
  if (table.uses_roof_shape())
    check_shapes(path, options, table.rows());
  else if (!options.roof_shape.empty())
    throw InputError(
        {"--roof-shape", path.string() + " has the participations itself", "leave it out", ""});
  return {std::move(table.modes).checked(path), table.has_damping()};
}

}  // namespace glissade
