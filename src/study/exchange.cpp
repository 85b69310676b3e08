// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/exchange.hpp"

#include "glissade/core/bytes.hpp"

namespace glissade {

std::vector<char> pack(const Suite& suite) {
  ByteWriter out;
  out.put(suite.name).put(suite.description).put(suite.motions.size());
  for (const Motion& m : suite.motions) {
    out.put(m.id)
        .put(m.event)
        .put(m.station)
        .put(m.magnitude)
        .put(m.distance_km)
        .put(m.vs30_mps)
        .put(m.scale)
        .put(m.dt_s);
    out.put(m.horizontal_mps2[0]).put(m.horizontal_mps2[1]).put(m.vertical_mps2);
  }
  out.put(suite.target.has_value());
  if (suite.target) {
    const DesignTarget& t = *suite.target;
    out.put(t.edition).put(t.ss_g).put(t.s1_g).put(t.site_classes).put(t.tl_s);
  }
  return out.take();
}

Suite unpack_suite(const std::vector<char>& bytes) {
  ByteReader in(bytes);
  Suite suite;
  std::size_t count = 0;
  in.get(suite.name).get(suite.description).get(count);
  suite.motions.resize(count);
  for (Motion& m : suite.motions) {
    in.get(m.id)
        .get(m.event)
        .get(m.station)
        .get(m.magnitude)
        .get(m.distance_km)
        .get(m.vs30_mps)
        .get(m.scale)
        .get(m.dt_s);
    in.get(m.horizontal_mps2[0]).get(m.horizontal_mps2[1]).get(m.vertical_mps2);
  }
  bool has_target = false;
  in.get(has_target);
  if (has_target) {
    DesignTarget t;
    in.get(t.edition).get(t.ss_g).get(t.s1_g).get(t.site_classes).get(t.tl_s);
    suite.target = t;
  }
  return suite;
}

std::vector<char> pack(const std::vector<UnitResult>& results) {
  ByteWriter out;
  out.put(results.size());
  for (const UnitResult& result : results) {
    const WorkCount& c = result.count;
    out.put(result.unit).put(result.runs.size());
    out.put(c.integrated).put(c.searched).put(c.roofs);
    out.put(c.held).put(c.from_curve).put(c.beyond).put(c.decided);
    for (const UnitResult::Run& run : result.runs)
      out.put(run.peak_displacement_m)
          .put(run.peak_vector_m)
          .put(run.uplift)
          .put(run.tips)
          .put(run.capacity)
          .put(run.crossing_time_s)
          .put(run.crossing_speed_mps);
  }
  return out.take();
}

std::vector<UnitResult> unpack_unit_results(const std::vector<char>& bytes) {
  ByteReader in(bytes);
  std::size_t count = 0;
  in.get(count);
  std::vector<UnitResult> results(count);
  for (UnitResult& result : results) {
    std::size_t runs = 0;
    WorkCount& c = result.count;
    in.get(result.unit).get(runs);
    in.get(c.integrated).get(c.searched).get(c.roofs);
    in.get(c.held).get(c.from_curve).get(c.beyond).get(c.decided);
    result.runs.resize(runs);
    for (UnitResult::Run& run : result.runs)
      in.get(run.peak_displacement_m)
          .get(run.peak_vector_m)
          .get(run.uplift)
          .get(run.tips)
          .get(run.capacity)
          .get(run.crossing_time_s)
          .get(run.crossing_speed_mps);
  }
  return results;
}

}  // namespace glissade
