// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace glissade {

/// The keys of a study file with their meaning, as text for a terminal. @param wanted a table
/// ("building"), a key ("building.period_s", "period_s"), a value ("random") or an intensity
/// measure ("sa_g", "sa"), with the keys of a project file of that name; empty: all of a study.
/// Empty text where there is no such.
std::string grammar_text(const std::string& wanted);
/// The key or table of a study or project whose name is nearest; "" if none is near.
std::string nearest_grammar_key(const std::string& wanted);

/// The same as a page in Markdown: studies/GRAMMAR.md.
std::string grammar_page();

}  // namespace glissade
