// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/run/exchange.hpp"

#include <map>

#include "glissade/core/bytes.hpp"
#include "glissade/core/hash.hpp"

namespace glissade {

namespace {

/// The fields of a motion (but its samples) and of a target, each named once for both directions.
template <class M, class Visit>
void for_each_part(M& m, Visit visit) {
  visit(m.id), visit(m.event), visit(m.station);
  visit(m.magnitude), visit(m.distance_km), visit(m.vs30_mps), visit(m.scale), visit(m.dt_s);
  visit(m.contradictions), visit(m.notes), visit(m.processing);
  visit(m.starts_are_assumed);
}
template <class M, class Visit>
void for_each_component(M& m, Visit visit) {
  visit(m.horizontal_mps2[0]), visit(m.horizontal_mps2[1]), visit(m.vertical_mps2);
}
template <class T, class Visit>
void for_each_target_part(T& t, Visit visit) {
  visit(t.edition), visit(t.ss_g), visit(t.s1_g), visit(t.site_classes), visit(t.tl_s);
  visit(t.sds_g), visit(t.sd1_g), visit(t.period_s), visit(t.design_sa_g);
}

}  // namespace

PackedSuites pack(const std::vector<Suite>& suites) {
  ByteWriter out;
  std::vector<double> samples;
  std::map<const double*, std::size_t> first_of;  // components that are shared
  const auto put = [&](const auto& part) { out.put(part); };
  out.put(suites.size());
  for (const Suite& suite : suites) {
    out.put(suite.name).put(suite.description).put(suite.nearest_to_target).put(suite.of_roof);
    out.put(suite.motions.size());
    for (const Motion& m : suite.motions) {
      for_each_part(m, put);
      for_each_component(m, [&](const Samples& component) {
        const auto [first, is_new] = first_of.try_emplace(component.data(), samples.size());
        out.put(component.size()).put(first->second);
        if (is_new) samples.insert(samples.end(), component.begin(), component.end());
      });
    }
    out.put(suite.target.has_value());
    if (suite.target) for_each_target_part(*suite.target, put);
  }
  return {out.take(), std::move(samples)};
}

std::vector<Suite> unpack_suites(std::span<const char> headers,
                                 std::span<const double> samples_mps2) {
  ByteReader in(headers);
  const auto get = [&](auto& part) { in.get(part); };
  std::size_t suites = 0, motions = 0;
  in.get(suites);
  std::vector<Suite> all(suites);
  for (Suite& suite : all) {
    in.get(suite.name).get(suite.description).get(suite.nearest_to_target).get(suite.of_roof);
    in.get(motions);
    suite.motions.resize(motions);
    for (Motion& m : suite.motions) {
      for_each_part(m, get);
      for_each_component(m, [&](Samples& component) {
        std::size_t size = 0, first = 0;
        in.get(size).get(first);
        if (first > samples_mps2.size() || size > samples_mps2.size() - first) throw ShortMessage();
        component = Samples::elsewhere(samples_mps2.subspan(first, size));
      });
    }
    bool has_target = false;
    in.get(has_target);
    if (has_target) for_each_target_part(suite.target.emplace(), get);
  }
  return all;
}

namespace {

/// A unit's result; its fields named once for both directions.
template <class R, class Visit>
void for_each_result_part(R& result, Visit visit) {
  visit(result.unit), visit(result.count);
  for_each_history_field([&](auto field) { visit(result.fields.*field.of); });
}

}  // namespace

std::vector<char> pack(const UnitResult& result) {
  ByteWriter out;
  for_each_result_part(result, [&](const auto& part) { out.put(part); });
  return out.take();
}

UnitResult unpack_unit_result(std::span<const char> bytes) {
  ByteReader in(bytes);
  UnitResult result;
  for_each_result_part(result, [&](auto& part) { in.get(part); });
  if (!in.at_end()) throw ShortMessage();
  return result;
}

bool fits(const Plan& plan, const UnitResult& result) {
  if (result.unit >= plan.units.size()) return false;
  const KeptFields kept(plan.config);
  const std::size_t cases = plan.units[result.unit].count;
  bool all = true;
  for_each_history_field([&](auto field) {
    const std::size_t size = kept.has(field) ? cases * depth_of(plan.config, field.depth) : 0;
    all = all && (result.fields.*field.of).size() == size;
  });
  return all;
}

std::string unit_layout(const Plan& plan) {
  Hasher hasher;
  hasher.number(std::uint64_t{sizeof(WorkCount)});
  for_each_history_field([&](auto field) { hasher.text(field.name); });
  for (const WorkUnit& unit : plan.units)
    hasher.number(std::uint64_t{unit.record}).number(std::uint64_t{unit.first});
  return to_hex(hasher.value());
}

}  // namespace glissade
