// SPDX-License-Identifier: GPL-3.0-or-later
// Record files of all formats. Each input is read as it is, with a time step given, with time step
// and units given, and the first component of several with units and a gain.
#include <algorithm>
#include <cmath>

#include "check.hpp"
#include "glissade/io/record_file.hpp"

namespace {

void read(const std::filesystem::path& file, const glissade::RecordFileOptions& options) {
  using glissade::fuzz::check;
  glissade::fuzz::may_refuse([&] {
    const glissade::Record record = read_record(file, options);
    check(std::isfinite(record.dt_s) && record.dt_s > 0.0, "the step is finite and above zero");
    check(!record.acceleration_mps2.empty(), "there is a sample");
    check(std::all_of(record.acceleration_mps2.begin(), record.acceleration_mps2.end(),
                      [](double a) { return std::isfinite(a); }),
          "every sample is finite, in m/s2 too");
  });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto file = glissade::fuzz::input_file(data, size);
  read(file, {});
  read(file, {.dt_s = 0.01, .units = {}, .units_if_not_stated = glissade::AccelerationUnits::mps2});
  read(file, {.dt_s = 0.0039, .units = glissade::AccelerationUnits::g});
  read(file, {.dt_s = {},
              .units = glissade::AccelerationUnits::mps2,
              .units_if_not_stated = {},
              .component = "1",
              .counts_per_unit = 1000.0});
  return 0;
}
