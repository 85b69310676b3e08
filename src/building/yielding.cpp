// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/building/yielding.hpp"

#include <sstream>

#include "glissade/building/rigid.hpp"
#include "glissade/core/contract.hpp"
#include "glissade/core/error.hpp"

namespace glissade {

Yielding yielding_for(const YieldCoefficient& strength, double hardening_ratio) {
  GLISSADE_EXPECTS(strength.force_over_weight > 0.0 && strength.gravity_mps2 > 0.0);
  GLISSADE_EXPECTS(hardening_ratio >= 0.0 && hardening_ratio < 1.0);
  return {strength.force_over_weight * strength.gravity_mps2, hardening_ratio};
}

Yielding yielding_for(const ReducedDemand& strength, double hardening_ratio) {
  GLISSADE_EXPECTS(strength.elastic_mps2 > 0.0 && strength.reduction >= 1.0);
  GLISSADE_EXPECTS(hardening_ratio >= 0.0 && hardening_ratio < 1.0);
  return {strength.elastic_mps2 / strength.reduction, hardening_ratio};
}

void require_no_rigid_spring(const Oscillator& oscillator, const Yielding& yielding, double dt_s) {
  if (!yielding.yields() || !is_rigid(oscillator, dt_s)) return;
  std::ostringstream what;
  what << "a building with a period of " << oscillator.period_s
       << " s yields, but is rigid under a record with a time step of " << dt_s << " s";
  throw InputError({"", what.str(),
                    "give a period of at least a sixteenth of the time step, or no yielding", ""});
}

}  // namespace glissade
