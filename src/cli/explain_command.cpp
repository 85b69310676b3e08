// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "commands.hpp"
#include "glissade/core/error.hpp"
#include "glissade/io/study_grammar.hpp"
#include "shared/put.hpp"

namespace glissade::cli {

void add_explain(CLI::App& program) {
  struct Options {
    std::string key;
    bool markdown = false;
  };
  auto o = std::make_shared<Options>();
  CLI::App* command =
      program.add_subcommand("explain", "Explain the keys of a study or project file");
  command->add_option("key", o->key,
                      "a table, a key, a value or a measure: building,\nperiod_s, random, uniform, "
                      "sa_g [all keys of a study]");
  command->add_flag("--markdown", o->markdown, "print the page studies/GRAMMAR.md");
  command->callback([o] {
    if (o->markdown) {
      put("{}", grammar_page());
      return;
    }
    const std::string text = grammar_text(o->key);
    if (text.empty()) {
      const std::string nearest = nearest_grammar_key(o->key);
      throw InputError({"", "there is no table, key, value or measure " + o->key,
                        (nearest.empty() ? "" : "did you mean " + nearest + "? ") +
                            "`glissade explain` lists those of a study, `glissade clearance "
                            "--example` those of a project",
                        ""});
    }
    put("{}", text);
  });
}

}  // namespace glissade::cli
