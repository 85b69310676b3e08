// SPDX-License-Identifier: GPL-3.0-or-later
#include "roof_times.hpp"

#include <array>
#include <memory>

#include "building/oscillator_bank.hpp"
#include "glissade/building/motion_table.hpp"
#include "timing.hpp"
#include "unit/block/reference.hpp"

namespace glissade::bench {
namespace {

constexpr std::size_t bank_size = building_detail::OscillatorBank::size;

constexpr std::size_t samples = 8000;

template <class Run>
double per_node_and_oscillator_ns(Run run) {
  std::vector<double> times;
  for (int round = 0; round < 25; ++round) {
    const auto start = Clock::now();
    run();
    times.push_back(seconds_since(start));
  }
  return 1e9 * median(times) / static_cast<double>(samples * bank_size);
}

}  // namespace

RoofTimes roof_times() {
  const auto ground = std::make_shared<GroundTable>(0.005, test::made_up_record(samples, 3, 4.0));
  std::vector<Modes> oscillators;
  for (std::size_t k = 0; k < bank_size; ++k)
    oscillators.push_back({0.2 + 0.1 * static_cast<double>(k), 0.05});
  const std::vector<RoofMotionOptions> follow(bank_size);  // not beyond the record
  std::vector<MotionTable> tables(bank_size);
  RoofTimes times;
  times.whole_ns =
      per_node_and_oscillator_ns([&] { tabulate_responses(ground, oscillators, follow, tables); });
  times.bounds_ns = per_node_and_oscillator_ns([&] {
    for (MotionTable& table : tables) building_detail::bound_response(table);
  });
  std::array<double*, bank_size> x{}, y{};
  for (std::size_t k = 0; k < bank_size; ++k) {
    x[k] = tables[k].x.data();
    y[k] = tables[k].y.data();
  }
  building_detail::OscillatorBank bank;
  for (std::size_t k = 0; k < bank_size; ++k)
    bank.set(k, oscillators[k][0].oscillator(), ground->step_s());
  times.filter_ns = per_node_and_oscillator_ns([&] {
    building_detail::advance(bank, ground->acceleration_mps2(), 0, samples - 1, x.data(), y.data());
  });
  const std::vector<double> record = test::made_up_record(samples, 3, 4.0);
  times.ground_ns = static_cast<double>(bank_size) * per_node_and_oscillator_ns([&] {
                      tabulate_rigid(std::make_shared<GroundTable>(0.005, record));
                    });
  return times;
}

}  // namespace glissade::bench
