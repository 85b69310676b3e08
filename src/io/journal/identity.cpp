// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "glissade/core/bytes.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/file.hpp"
#include "glissade/core/folder.hpp"
#include "glissade/core/hash.hpp"
#include "glissade/core/input_file.hpp"
#include "glissade/core/mathematics.hpp"
#include "glissade/core/output_file.hpp"
#include "glissade/io/journal.hpp"
#include "glissade/study/run/exchange.hpp"
#include "journal/frame.hpp"
#include "journal/names.hpp"

namespace glissade {

namespace fs = std::filesystem;

JournalNames::JournalNames(const fs::path& run_folder)
    : folder(run_folder / "journal"), identity(folder / "run"), lock(folder / "lock") {}

fs::path JournalNames::units(int rank, int session) const {
  return folder / fmt::format("{}-{}.units", rank, session);
}

namespace {

/// "0-1.units"
bool is_name_of_units(const fs::path& file) {
  const std::string name = file.stem().string();
  const auto is_number = [](std::string_view text) {
    return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
  };
  const std::size_t dash = name.find('-');
  return file.extension() == ".units" && dash != std::string::npos &&
         is_number(std::string_view(name).substr(0, dash)) &&
         is_number(std::string_view(name).substr(dash + 1));
}

}  // namespace

std::vector<fs::path> JournalNames::all_units() const {
  std::vector<fs::path> files = files_in(folder);
  std::erase_if(files, [](const fs::path& file) {
    return !is_name_of_units(file) || !fs::is_regular_file(status_of(file));
  });
  return files;
}

std::string units_head(const RunIdentity& run) {
  Hasher hasher;
  hasher.text(run.program_version).text(run.plan_hash).text(run.layout);
  const std::string head = "glissade units 1 " + to_hex(hasher.value());
  return framed(head);
}

namespace {

constexpr const char* identity_format = "glissade run 4";
constexpr std::uint64_t most_identity_bytes = 64u << 20;

/// The line at which two texts first differ.
struct Difference {
  std::size_t line = 1;
  std::string was, is;
};

Difference first_difference(const std::string& was, const std::string& is) {
  const auto same = static_cast<std::size_t>(std::ranges::mismatch(was, is).in1 - was.begin());
  const std::size_t begin = same == 0 ? 0 : was.rfind('\n', same - 1) + 1;
  const auto line_of = [&](const std::string& text) {
    return begin < text.size() ? text.substr(begin, text.find('\n', begin) - begin) : "";
  };
  return {1 + static_cast<std::size_t>(std::count(was.begin(), was.begin() + begin, '\n')),
          line_of(was), line_of(is)};
}

}  // namespace

RunIdentity identity_of(const Plan& plan, const std::string& program_version) {
  return {program_version,
          plan.hash,
          mathematics(),
          unit_layout(plan),
          fs::absolute(plan.config.file),
          plan.config.source_text,
          plan.motions_text,
          {}};
}

void write_identity(const fs::path& run_folder, const RunIdentity& run) {
  const std::vector<char> content = ByteWriter()
                                        .put(std::string(identity_format))
                                        .put(run.program_version)
                                        .put(run.plan_hash)
                                        .put(run.mathematics)
                                        .put(run.layout)
                                        .put(run.study_file.string())
                                        .put(run.study_text)
                                        .put(run.motions_text)
                                        .put(run.part)
                                        .take();
  write_text_file(JournalNames(run_folder).identity, framed(content));
}

bool has_identity(const fs::path& run_folder) {
  return fs::exists(status_of(JournalNames(run_folder).identity));
}

RunIdentity read_identity(const fs::path& run_folder) {
  if (!has_identity(run_folder)) {
    throw InputError({run_folder.string(), "holds no run that can be resumed",
                      "give the folder of a run that was stopped, or run the study anew", ""});
  }
  const fs::path file = JournalNames(run_folder).identity;
  RunIdentity run;
  std::string format, study_file;
  try {
    const auto content = FrameReader(file, most_identity_bytes).next();
    if (!content) throw ShortMessage();
    ByteReader in(*content);
    in.get(format);
    if (format != identity_format) throw ShortMessage();
    in.get(run.program_version).get(run.plan_hash).get(run.mathematics).get(run.layout);
    in.get(study_file).get(run.study_text).get(run.motions_text).get(run.part);
    constexpr std::uint64_t most_parts = 1000000;
    if (run.part.count > most_parts || run.part.number > run.part.count ||
        (run.part.number == 0 && !run.part.is_all()))
      throw ShortMessage();
  } catch (const ShortMessage&) {
    throw InputError({file.string(), "is damaged, or of another version of glissade",
                      "run the study anew, with --overwrite or in another folder", ""});
  }
  run.study_file = study_file;
  return run;
}

namespace {

std::string or_anew(const std::string& what) {
  return what + ", or run the study in another folder";
}

Problem changed_study(const std::string& begun, const fs::path& file, const std::string& now,
                      const fs::path& run_folder) {
  const Difference d = first_difference(begun, now);
  return {fmt::format("{}:{}", file.string(), d.line),
          fmt::format("the study has changed since the run in {} began: \"{}\" was \"{}\"",
                      run_folder.string(), d.is.substr(0, 100), d.was.substr(0, 100)),
          or_anew("restore the study file"), ""};
}

}  // namespace

void check_same_study(const std::string& begun, const fs::path& file, const std::string& now,
                      const fs::path& run_folder) {
  if (begun != now) throw InputError(changed_study(begun, file, now, run_folder));
}

void check_same_run(const RunIdentity& begun, const RunIdentity& now, const fs::path& run_folder) {
  ProblemList problems;
  const auto report = [&](const std::string& where, const std::string& what,
                          const std::string& suggestion) {
    problems.add({where, what, suggestion, ""});
  };
  if (begun.program_version != now.program_version) {
    report(run_folder.string(),
           fmt::format("the run was begun by glissade {}, this is {}", begun.program_version,
                       now.program_version),
           or_anew("resume it with the program that began it"));
  }
  const bool same_mathematics = begun.mathematics == now.mathematics;
  if (!same_mathematics) {
    report(run_folder.string(),
           "the run was begun where exp, sin and other functions of the C library give other last "
           "digits: on another kind of processor, or with another C library",
           or_anew("resume it on a machine of the kind that began it"));
  }
  if (begun.study_text != now.study_text) {
    problems.add(changed_study(begun.study_text, now.study_file, now.study_text, run_folder));
  } else if (same_mathematics && begun.motions_text != now.motions_text) {
    const Difference d = first_difference(begun.motions_text, now.motions_text);
    const auto name = [](const std::string& line) {
      return line.empty() ? "(none)" : line.substr(0, line.rfind(' '));
    };
    report(run_folder.string(),
           name(d.is) == name(d.was)
               ? "this is not as it was when the run began: " + name(d.is)
               : "where the run began with " + name(d.was) + " there is " + name(d.is),
           or_anew("restore the suite and its records"));
  } else if (same_mathematics && begun.plan_hash != now.plan_hash) {
    report(run_folder.string(),
           fmt::format("the run was begun with plan {}, this is {}: a file that the study names "
                       "beside its suites has changed",
                       begun.plan_hash, now.plan_hash),
           or_anew("restore it"));
  } else if (problems.empty() && begun.layout != now.layout) {
    report(run_folder.string(), "the run was begun by another build of glissade",
           or_anew("resume it with the program that began it"));
  }
  problems.throw_if_any();
}

}  // namespace glissade
