// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/study/plan/plan.hpp"
#include "glissade/study/results.hpp"

namespace glissade {

ModelText model_text(const Plan& plan);
/// As in ModelText.
std::string modes_text(const Plan& plan);
double dbe_level(const Plan& plan);

}  // namespace glissade
