// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "glissade/design/project.hpp"

// What a verdict rests on and no analysis finds: one table, from which every output takes what it
// shows and judges.
namespace glissade {

/// What a project states of a premise.
struct Statement {
  std::string text;  ///< "not stated", "dry TPO"
  bool is_met = false;
};

/// A row of the table. Limits that name no clause are of this program.
struct PremiseRow {
  const char *what, *key, *required;  ///< "surface of the friction tests", "friction.surface"
  /// Nothing where the project does not need it.
  std::optional<Statement> (*find)(const Project& project);
};
std::span<const PremiseRow> premise_rows();

/// Of one project. No separation is called sufficient before all are met.
struct Premise {
  const char *what, *key, *required;
  Statement found;
};
std::vector<Premise> premises_of(const Project& project);
/// "roof diaphragm: not stated; required: rigid ... (building.diaphragm)".
std::string not_met_text(const Premise& premise);
/// Whether a warning of the project's studies is that of a premise.
bool is_of_premise(const Project& project, const std::string& warning);

}  // namespace glissade
