// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "glissade/core/file_name.hpp"

namespace glissade {

struct DataColumn {
  std::string name;         ///< "mean_slip_m"
  std::string unit;         ///< "m"; "-" without one
  std::string description;  ///< a sentence's part
  std::variant<std::vector<double>, std::vector<std::string>> values;
};

/// Numbers and texts by column, in SI units, as a results file contains them.
struct DataTable {
  FileName name;
  std::string title;  ///< one line: what it is
  std::vector<DataColumn> columns;
};

}  // namespace glissade
