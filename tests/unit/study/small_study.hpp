// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "glissade/study/plan.hpp"
#include "unit/block/reference.hpp"

namespace glissade::test {

/// Three made-up three-component motions of 6 s.
inline Suite small_suite() {
  Suite suite;
  suite.name = "small";
  for (unsigned i = 0; i < 3; ++i) {
    Motion m;
    m.id = "motion" + std::to_string(i);
    m.dt_s = 0.01;
    m.scale = 1.0 + 0.5 * i;
    m.horizontal_mps2 = {made_up_record(600, 10 * i + 1, 3.0),
                         made_up_record(600, 10 * i + 2, 2.0)};
    m.vertical_mps2 = made_up_record(600, 10 * i + 3, 1.0);
    suite.motions.push_back(m);
  }
  suite.target = DesignTarget{AsceEdition::asce7_10, 1.5, 0.6, {SiteClass::d}, 8.0};
  return suite;
}

/// Forty samples of everything uncertain on a sds_g study of eight levels.
inline StudyConfig small_config() {
  StudyConfig c;
  c.name = "small";
  c.seed = 5;
  c.source_text = "small study";
  c.intensity.measure = IntensityMeasure::sds_g;
  c.intensity.levels = {0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 3.0, 4.0};
  c.building.period_s = Uniform{0.1, 0.8};
  c.roof.slope_deg = Discrete{{0.0, 1.19, 4.0}, {1.0, 1.0, 1.0}};
  c.friction.mu = TruncatedNormal{0.4, 0.05, 0.0, INFINITY};
  c.sampling.samples = 40;
  c.sampling.method = SamplingMethod::monte_carlo;
  c.sampling.bootstrap_replicates = 200;
  c.thresholds_m = {0.02, 0.1, 1.0};
  c.standards.compare = {Standard::seaoc_pv1_2012, Standard::asce7_16};
  return c;
}

}  // namespace glissade::test
