// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "glissade/report/table.hpp"

namespace glissade::cli {

/// A number that a command found: a row of its table, and a key of its JSON object.
struct Finding {
  std::string key;    ///< "median"; its interval is "median_interval_95"
  std::string label;  ///< empty, or a value that is nan: in JSON only
  double value = 0.0;
  std::optional<Interval> interval = {};
  std::string unit = "";  ///< "m": shown with inches too
};

nlohmann::ordered_json to_json(const std::vector<Finding>& findings);
nlohmann::ordered_json to_json(const Interval& interval);
Table to_table(const std::string& title, const std::vector<Finding>& findings);

}  // namespace glissade::cli
