// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glissade/report/package.hpp"
#include "page/page.hpp"

// The sections of a calculation package, and what they are put together from.
namespace glissade {

/// Of the calculation package, in their order.
enum class Section {
  scope,
  criteria,
  building,
  array,
  friction,
  motions,
  result,
  separations,
  uncertainty,
  probability,
  plausibility,
  check,
  provisions,
  checks,
  references,
  inputs
};
/// As it is printed, from 1.
constexpr int number_of(Section section) { return static_cast<int>(section) + 1; }
Html section_heading(Section section);
/// Links to all headings.
Html contents_html();

/// Rows are whole; a short table is on one page, a longer one may go on with its header repeated.
Html page_table(const Table& table);
/// Without a caption, which the heading above it has.
Html plain_table(const Table& table);
Html equation(const std::string& text);

/// What the motions are, and how they are scaled.
Html motions_html(const CalculationPackage& package, const std::vector<DrawnFigure>& figures);
/// The model, its displacements and how they lead to the one that governs.
/// @param figure of the demand
Html result_html(const CalculationPackage& package, const Html& figure);
/// What a reader can compute by hand, beside what is required.
Html by_hand_html(const CalculationPackage& package);
/// Checks, limits and peer review.
Html checks_html(const CalculationPackage& package);
Html references_html();
/// Program, files and the project file.
Html inputs_html(const CalculationPackage& package);

}  // namespace glissade
