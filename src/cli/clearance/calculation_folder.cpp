// SPDX-License-Identifier: GPL-3.0-or-later
#include "clearance/calculation_folder.hpp"

#include <algorithm>
#include <optional>

#include "commands.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/file.hpp"
#include "glissade/core/folder.hpp"
#include "glissade/io/results_file.hpp"
#include "glissade/io/sha256.hpp"
#include "glissade/io/study_file.hpp"
#include "glissade/io/suite_file.hpp"
#include "glissade/parallel/together.hpp"
#include "glissade/report/results_folder.hpp"
#include "glissade/study/plan/plan.hpp"
#include "run/run_folder.hpp"
#include "run/run_study.hpp"
#include "shared/output_rule.hpp"
#include "shared/put.hpp"

namespace glissade::cli {
namespace {

namespace fs = std::filesystem;

/// Throws InputError where they are not those of the project as it is now.
void check_results(const fs::path& folder, const fs::path& file, const std::string& text) {
  const ResultsOrigin origin = read_origin(folder / "results.h5");
  const StudyConfig study = read_study(file);
  if (origin.study_text == text &&
      origin.plan_hash == make_plan(study, {load_suite(study.suite_files.front())}).hash)
    return;
  throw InputError({(folder / "results.h5").string(),
                    origin.study_text == text
                        ? "is of other motions: the suite, or a file that it names, has changed"
                        : "is not of the study that the project now gives",
                    "undo the change, or begin again with --overwrite", ""});
}

/// Of a study that is refused nothing stays, and an earlier file of the name comes back.
void put_back(const fs::path& file, const std::optional<std::string>& earlier) {
  std::error_code ignored;
  if (earlier)
    write_text_file(file, *earlier);
  else
    fs::remove(file, ignored);
}

std::vector<char> path_text(const fs::path& path) {
  const std::string text = path.string();
  return {text.begin(), text.end()};
}

}  // namespace

void CalculationFolder::begin(
    const std::function<std::vector<std::string>(const fs::path&)>& read) {
  on_root(world_, [&] {
    const bool resumes = !options_.resume.empty();
    if (resumes) identity_ = read_calculation(options_.resume);
    const fs::path file = resumes ? identity_.project : fs::path(options_.project);
    path_ = resumes                ? fs::path(options_.resume)
            : options_.out.empty() ? fs::path("results") / file.stem()
                                   : fs::path(options_.out);
    if (resumes) check_own(path_);
    studies_ = read(file);
    const CalculationIdentity now{fs::absolute(file), sha256_of_file(file)};
    if (resumes && now.project_sha256 != identity_.project_sha256)
      throw InputError({file.string(), "was changed since the calculation began",
                        "undo the change, or begin again with --overwrite", ""});
    if (resumes && !is_part_ && is_whole()) {
      put("{} is finished: {}\n", path_.string(), (path_ / (page_ + ".html")).string());
      throw ExitStatus{0};
    }
    identity_ = now;
    check_project_path(identity_.project);
    if (!resumes) check_calculation_folder(path_, options_.overwrite);
    std::vector<std::string> files{page_ + ".json"}, made_later;
    for (const std::string& study : studies_)
      if (study.find('/') == std::string::npos) files.push_back(study + ".toml");
    for (const char* ending : {".html", ".pdf", ".xlsx"}) made_later.push_back(page_ + ending);
    check_files(path_, files);
    check_files(path_, made_later);
    lock_ = take_folder(path_);
    remove_listed(path_);  // earlier
    begin_files(path_, files);
    write_begun_calculation(identity_, RunState::started, path_);
  });
  std::vector<char> out = path_text(path_);
  world_.broadcast(out);
  path_ = std::string(out.begin(), out.end());
}

void CalculationFolder::run(const std::string& name,
                            const std::function<std::string()>& text) const {
  const fs::path file = path_ / (name + ".toml"), folder = path_ / name;
  std::optional<std::string> earlier;
  try {
    const bool goes_on = root_says(world_, [&] {
      const std::string study = text();
      if (is_there(file)) earlier = read_text_file(file);
      write_text_file(file, study);
      const bool resumes = !options_.resume.empty(), is_done = resumes && has_results(folder);
      if (is_done) check_results(folder, file, study);
      return is_done || (resumes && has_identity(folder));
    });
    run_study({.study = file.string(),
               .out = goes_on ? "" : folder.string(),
               .resume = goes_on ? folder.string() : "",
               .overwrite = options_.overwrite || !options_.resume.empty(),
               .quiet = true,
               .made_of = identity_.project,
               .stop_file = path_ / "stop"},
              world_);
  } catch (const ExitStatus& exit) {
    // One that goes on has the study of its project, which is as it was.
    if (world_.is_root() && exit.status == 2 && options_.resume.empty()) put_back(file, earlier);
    if (exit.status != 0) throw;  // 0: it was finished
  }
}

/// Everything that a finished calculation writes is there, and its results are whole.
bool CalculationFolder::is_whole() const {
  return is_finished_calculation(path_) && glissade::is_whole(path_) &&
         std::ranges::all_of(studies_,
                             [&](const std::string& study) { return has_results(path_ / study); });
}

void CalculationFolder::finish(const std::function<void()>& write,
                               const std::function<void()>& state) {
  const auto try_to = [&](const std::function<void()>& step) {
    write_beside(path_, "keeps the results of its studies", resume_calculation_command(path_),
                 step);
  };
  try_to(write);
  lock_->check();
  try_to(state);
  lock_->give_back();
}

void CalculationFolder::leave(int status) noexcept try {
  std::error_code ignored;
  fs::remove(path_ / "stop", ignored);
  const bool has_study = !studies_.empty() && is_there(path_ / studies_.front());
  if (status == 2 && !has_study) {
    fs::remove(path_ / "run.json", ignored);
    remove_listed(path_);
    lock_.reset();
    fs::remove(path_, ignored);  // if empty
  } else if (has_study) {
    write_begun_calculation(identity_, RunState::stopped, path_);
  }
} catch (const std::exception&) {  // run.json stays as it was
}

std::string page_text(const fs::path& folder, const std::string& page, bool is_printed) {
  return (folder / (page + (is_printed ? ".pdf" : ".html"))).string() +
         (is_printed ? "" : "   (print it from a browser: WeasyPrint is not installed)");
}

}  // namespace glissade::cli
