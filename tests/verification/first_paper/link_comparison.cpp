// SPDX-License-Identifier: GPL-3.0-or-later
#include "link_comparison.hpp"

#include <algorithm>
#include <cmath>

#include "at_one_g.hpp"
#include "glissade/block/rodriguez_nikl.hpp"
#include "verification/case.hpp"

namespace glissade::verification {
namespace {

using test::ElasticLink;
using test::FrictionLaw;

LinkModel elastic(const std::string& name, const ElasticLink& link) {
  return {"elastic link, " + name,
          [link](const RoofAcceleration& roof, const Block& block) {
            return slide_on_elastic_link(roof, block, link);
          },
          link};
}

LinkModel published(const std::string& name, int substeps) {
  return {name,
          [substeps](const RoofAcceleration& roof, const Block& block) {
            const SlipResult r = slide_rodriguez_nikl(roof, block, substeps);
            return test::LinkSlip{r.peak_displacement_m, r.residual};
          },
          {}};
}

std::vector<LinkScene> scenes() {
  std::vector<LinkScene> all;
  for (const double mu : {0.02, 0.05, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7})
    all.push_back({mu, 0.0});
  for (const double mu : {0.1, 0.2, 0.3, 0.4, 0.5, 0.6}) all.push_back({mu, 4.0});
  return all;
}

}  // namespace

const std::vector<LinkModel>& link_models() {
  static const std::vector<LinkModel> all = {
      elastic("100 N/mm, 1 ms, as the paper's", {}),
      elastic("100 N/mm, 0.25 ms", {.longest_substep_s = 0.00025}),
      elastic("10 N/mm, 1 ms", {.stiffness_npmm = 10.0}),
      elastic("1,000 N/mm, 1 ms", {.stiffness_npmm = 1000.0}),
      elastic("1,000 N/mm, 0.25 ms", {.stiffness_npmm = 1000.0, .longest_substep_s = 0.00025}),
      elastic("10,000 N/mm, 0.05 ms", {.stiffness_npmm = 10000.0, .longest_substep_s = 0.00005}),
      elastic("100 N/mm, 1 ms, CSI's rounded knee", {.law = FrictionLaw::wen}),
      published("published scheme, P = 64: 0.078 ms", 64),
      published("published scheme, P = 32: 0.156 ms, as the paper's", 32)};
  return all;
}

std::vector<LinkRun> run_links(const Suite& suite) {
  std::vector<LinkRun> runs;
  for (std::size_t motion = 0; motion < suite.motions.size(); ++motion) {
    const RoofAcceleration roof = at_one_g(suite.motions[motion]);
    for (const LinkScene& scene : scenes()) {
      LinkRun run{motion, scene, slide(roof, scene.block()), {}};
      for (const LinkModel& model : link_models())
        run.by_model.push_back(model.solve(roof, scene.block()));
      runs.push_back(run);
    }
  }
  return runs;
}

Spread spread(const std::vector<LinkRun>& runs, const Selection& selected,
              const std::function<double(const LinkRun&)>& value) {
  Spread result;
  std::size_t count = 0;
  for (const LinkRun& run : runs) {
    const Roof roof = run.scene.slope_deg == 0.0 ? Roof::flat : Roof::sloping;
    if (roof != selected.roof || run.motion >= selected.motions) continue;
    const double x = value(run);
    result.mean += x;
    result.largest = worse(result.largest, x);
    ++count;
  }
  result.mean /= static_cast<double>(count);
  return result;
}

double residual_error_m(const LinkRun& run, Model model) {
  return std::abs(std::abs(run.by_model[model].residual.along_m) -
                  std::abs(run.exact.residual.along_m));
}

}  // namespace glissade::verification
