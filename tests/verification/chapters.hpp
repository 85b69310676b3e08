// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "case.hpp"

namespace glissade::verification {

Chapter sliding_block(
    const Folders& folders);  ///< exact solutions, closed forms, physical checks, invariants
Chapter published_scheme(
    const Folders& folders);      ///< Rodriguez-Nikl's scheme converging to the exact solution
Chapter closed_form_solutions();  ///< pulses and harmonics, the block and the roof below it
Chapter event_kernel(const Folders& folders);  ///< the tabulated event search
Chapter buildings(const Folders& folders);
Chapter fragility();
Chapter sampling();
Chapter standards();
Chapter simulated_motions(const Folders& folders);
Chapter end_to_end(const Folders& folders);

}  // namespace glissade::verification
