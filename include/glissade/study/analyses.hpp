// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/study/analysis/base_shear.hpp"
#include "glissade/study/analysis/chart.hpp"
#include "glissade/study/analysis/clearance.hpp"
#include "glissade/study/analysis/fragility.hpp"
#include "glissade/study/analysis/hazard.hpp"
#include "glissade/study/analysis/impact.hpp"
#include "glissade/study/analysis/intensity_measures.hpp"
#include "glissade/study/analysis/model_uncertainty.hpp"
#include "glissade/study/analysis/rare.hpp"
#include "glissade/study/analysis/sampling_error.hpp"
#include "glissade/study/analysis/sensitivity.hpp"
#include "glissade/study/analysis/shape.hpp"
#include "glissade/study/analysis/standards.hpp"
#include "glissade/study/analysis/tipping.hpp"
#include "glissade/study/analysis/verdict.hpp"

namespace glissade {

/// All analyses, in the order in which they are read, made, stored and reported: one that reads
/// another's results comes after it. Where else an analysis is named, and why: src/README.md.
using Analyses =
    AnalysisList<ClearanceAnalysis, BaseShearAnalysis, FragilityAnalysis, StandardsAnalysis,
                 ImpactAnalysis, ShapeAnalysis, HazardAnalysis, ModelUncertaintyAnalysis,
                 ChartAnalysis, TippingAnalysis, VerdictAnalysis, SensitivityAnalysis,
                 SamplingErrorAnalysis, RareAnalysis, IntensityMeasuresAnalysis>;

}  // namespace glissade
