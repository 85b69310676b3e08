// SPDX-License-Identifier: GPL-3.0-or-later
// What `glissade fit` reads: counts and capacities. Each input is tried as both.
#include <cmath>

#include "check.hpp"
#include "glissade/io/fit_input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace glissade::fuzz;
  const auto file = input_file(data, size);
  may_refuse([&] {
    const auto stripes = glissade::read_counts(file);
    check(!stripes.empty(), "there is a level");
    for (const glissade::Stripe& s : stripes) {
      check(std::isfinite(s.intensity) && s.intensity > 0.0, "im is above zero");
      check(s.trials >= 1.0 && s.exceedances >= 0.0 && s.exceedances <= s.trials,
            "0 <= num_exceed <= num_gms");
    }
  });
  may_refuse([&] {
    const auto capacities = glissade::read_capacities(file);
    check(!capacities.empty(), "there is a capacity");
    for (const double c : capacities)
      check(std::isfinite(c) && c >= 0.0, "im_cap is not below zero");
  });
  return 0;
}
