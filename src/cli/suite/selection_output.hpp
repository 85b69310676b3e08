// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "glissade/core/error.hpp"
#include "glissade/motion/record_selection.hpp"
#include "glissade/report/table.hpp"

// What both selections of records print.
namespace glissade::cli {

/// A problem of a criterion becomes one of its options.
void by_option(Problem& problem);

/// Throws InputError where a library is not one of the ground.
Suite load_library(const std::string& file);

/// The records, their factors and misfits.
Table selected_table(const Suite& library, const std::vector<SelectedRecord>& records);
nlohmann::ordered_json selected_json(const Suite& library,
                                     const std::vector<SelectedRecord>& records);

void put_left_out(const Suite& library, const std::vector<LeftOutRecord>& left_out);
nlohmann::ordered_json left_out_json(const Suite& library,
                                     const std::vector<LeftOutRecord>& left_out);

}  // namespace glissade::cli
