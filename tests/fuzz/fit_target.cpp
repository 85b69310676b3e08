// SPDX-License-Identifier: GPL-3.0-or-later
// What `glissade fit` reads: counts, capacities and clouds. Each input is tried as all of them.
#include <cmath>

#include "check.hpp"
#include "glissade/io/fit_input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace glissade::fuzz;
  const auto file = input_file(data, size);
  const auto check_row = [](const auto& row) {
    check(row.weight >= 0.0 && std::isfinite(row.weight), "weight is not below zero");
  };
  may_refuse([&] {
    const auto counts = glissade::read_counts(file);
    check(!counts.rows.empty(), "there is a level");
    for (const glissade::Stripe& s : counts.rows) {
      check_row(s);
      check(std::isfinite(s.intensity) && s.intensity > 0.0, "im is above zero");
      check(s.trials >= 1.0 && s.exceedances >= 0.0 && s.exceedances <= s.trials,
            "0 <= num_exceed <= num_gms");
    }
  });
  may_refuse([&] {
    const auto capacities = glissade::read_capacities(file);
    check(!capacities.rows.empty(), "there is a capacity");
    for (const glissade::Bracket& row : capacities.rows) {
      check_row(row);
      check(std::isfinite(row.low) && row.low >= 0.0 && row.low <= row.high,
            "0 <= im_low <= im_high");
    }
  });
  may_refuse([&] {
    const auto cloud = glissade::read_cloud(file);
    check(!cloud.rows.empty(), "there is a point");
    for (const glissade::CloudPoint& row : cloud.rows) {
      check_row(row);
      check(std::isfinite(row.intensity) && row.intensity > 0.0, "im is above zero");
      check(std::isfinite(row.displacement) && row.displacement >= 0.0, "edp is not below zero");
    }
  });
  return 0;
}
