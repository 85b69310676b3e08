// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "glissade/io/record_file.hpp"
#include "records/at2_header.hpp"

namespace glissade {

/// The units of a record: those of its header, with which the options must agree, else those of the
/// options. Throws InputError where neither states them, and for velocities and displacements.
AccelerationUnits units_of(const std::filesystem::path& file, const At2Header& header,
                           const RecordFileOptions& options);

double mps2_per_unit(AccelerationUnits units);

}  // namespace glissade
