// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "case.hpp"

namespace glissade::verification {

Chapter sliding_block(const Folders& folders);  ///< exact solutions, closed forms, invariants
Chapter published_scheme(
    const Folders& folders);      ///< Rodriguez-Nikl's scheme converging to the exact solution
Chapter closed_form_solutions();  ///< pulses and harmonics, the block and the roof below it
Chapter table_kernel(const Folders& folders);  ///< the tabulated event search
Chapter buildings(const Folders& folders);
Chapter buildings_of_storeys();  ///< their modes, and an array on them
Chapter fragility();
Chapter interval_coverage();  ///< nominal 95 % against simulated studies
Chapter sampling();
Chapter standards();
Chapter simulated_motions(const Folders& folders);
Chapter end_to_end(const Folders& folders);
Chapter first_paper_checks(const Folders& folders);  ///< Rodriguez-Nikl et al.'s physical checks
Chapter first_paper_link(const Folders& folders);    ///< their comparison with SAP 2000
Chapter first_paper_convergence(const Folders& folders);
Chapter first_paper_parametric_study(const Folders& folders);
Chapter first_paper_charts(const Folders& folders);  ///< what they name as future work
Chapter second_paper_coupled();  ///< Walters et al.'s model: coupled building and array
Chapter second_paper_yielding();
Chapter second_paper_two_axes(const Folders& folders);
Chapter second_paper_friction();
Chapter second_paper_crossings(const Folders& folders);  ///< when and how fast a parapet is reached
Chapter second_paper_vertical(const Folders& folders);   ///< through its own oscillator
Chapter second_paper_statements(const Folders& folders);  ///< what they say beside what we find

}  // namespace glissade::verification
