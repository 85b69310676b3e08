// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace glissade::test {

/// All premises are met, by a suite of recorded motions beside it.
inline const std::string complete_project = R"([project]
name = "Roof of x_1, complete"
[site]
edition = "asce7_16"
ss_g = 1.3
s1_g = 0.45
site_class = "C"
tl_s = 8
risk_category = "III"
fault_distance_km = 30
[building]
period_s = 0.35
mass_ratio = 0.02
storeys = 2
diaphragm = "rigid"
[roof]
slope_deg = "0.25:12"
[friction]
mu = { mean = 0.7, std = 0.02 }
source = "report 7"
tests = 9
laboratory = "Own laboratory"
tested_on = "2024-10-14"
test_standard = "ASTM G115"
surface = "wet"
surface_description = "TPO, feet of EPDM"
[array]
centre_of_mass_m = "11 in"
support_spacing_m = "32 in"
interconnection = 0.2
[suite]
file = "recorded.toml"
[sampling]
samples = 2
[clearances]
similar_array_m = "30 ft"
obstruction_m = "30 ft"
parapet_edge_m = "30 ft"
open_edge_m = "30 ft"
[standards]
compare = "asce7_16"
)";

}  // namespace glissade::test
