// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "glissade/io/study_file.hpp"
#include "glissade/report/base_shear_report.hpp"
#include "glissade/report/clearance_report.hpp"
#include "verification/chapters.hpp"
#include "verification/first_paper/run_study.hpp"

namespace glissade::verification {
namespace {

/// What Walters et al. (2012) say on a topic that one of the studies is about.
struct Statement {
  std::optional<ClearanceTopic> topic;  ///< nothing: base shear
  const char* where;
  const char* says;
};

struct StatedStudy {
  const char* file;
  std::vector<Statement> statements;
  bool recorded = false;  ///< runs on recorded motions
};

const std::vector<StatedStudy>& stated_studies() {
  using enum ClearanceTopic;
  static const std::vector<StatedStudy> studies = {
      {"14_walters_example.toml",
       {{period, "Fig. 13",
         "10.21 in, at a period of 1.0 s, is the largest over the periods; clearance 1.1 x 10.21 = "
         "11.23 in"},
        {spectra, "Fig. 8",
         "significantly larger than the MCE on average at some periods (e.g., 0.2 s); 0.1 s and "
         "0.7 s were controlling periods"},
        {orientation, "Rooftop conditions",
         "it is conservative to orient the stronger component in the direction with the downhill "
         "roof slope"},
        {vertical, "Ground motion",
         "the effect of including the vertical ground motion is significant"}},
       true},
      {"15_walters_level_threshold.toml",
       {{level, "Fig. 14",
         "significant movement is not expected at Seismic Intensity Levels below Level 2"}}},
      {"16_walters_yielding.toml",
       {{yielding, "Fig. 15",
         "except for R = 2, yielding significantly reduces the sliding response of the array"}}},
      {"17_walters_base_shear.toml",
       {{std::nullopt, "Fig. 16",
         "the isolated array results in lower base shear than the fixed array, and even lower than "
         "the building without the array"}}},
      {"18_walters_slope.toml",
       {{slope, "Fig. 17",
         "maximum array displacement increases rapidly as slope increases; 1:12 to 1.5:12 should "
         "be regarded as a maximum"}}},
      {"19_walters_mce.toml",
       {{mce, "Fig. 18",
         "the peak DBE response (at T = 0.70 s) is close to the MCE response at 0.20 s"}}},
      {"20_walters_permutations.toml",
       {{orientation, "Rooftop conditions",
         "it is conservative to assume that the lower of the two effective friction coefficients "
         "is oriented in the downhill direction"},
        {mass, "Seismic mass of array",
         "at or between 5 % and 10 % of the building seismic mass"}}},
      {"21_walters_vertical.toml",
       {{vertical, "Building type and modal behavior",
         "it is important to study the sensitivity of the displacement to possible variations in "
         "vertical structure period"}}}};
  return studies;
}

Results results_of(const Folders& folders, const char* file) {
  return run_study(plan_of(read_study(folders.studies / file)));
}

/// By the number of the study.
using AllResults = std::map<std::string, Results>;

std::string number_of(const StatedStudy& study) { return std::string(study.file, 2); }

AllResults run_all(const Folders& folders) {
  AllResults results;
  for (const StatedStudy& study : stated_studies())
    if (!study.recorded) results[number_of(study)] = results_of(folders, study.file);
  return results;
}

std::string reading(const Results& results, const Statement& statement) {
  return statement.topic ? clearance_reading(results, *statement.topic)
                         : base_shear_sentences(results).front();
}

std::string rows(const AllResults& all, const StatedStudy& study) {
  // The page is the same on every machine: what rests on recorded motions stands in the studies'
  // page.
  const std::string elsewhere =
      "recorded motions: [studies](../../studies/README.md#the-second-paper)";
  const std::string number = number_of(study);
  std::string text;
  for (const Statement& s : study.statements)
    text += fmt::format("| {} | {} | {} | {} |\n", number, s.where, s.says,
                        study.recorded ? elsewhere : reading(all.at(number), s));
  return text;
}

double median_m(const Results& r, const Condition& at, Periods periods) {
  return over_orientations(r, {}, at, periods).median;
}

Condition last(const Results& r, ConditionAxis axis) {
  Condition at;
  at[axis] = r.conditions->grid.size(axis) - 1;
  return at;
}

const std::string paper = "Walters et al. 2012, ";

/// The largest over the periods, isolated over another support.
double largest_base_shear_ratio(const Results& r, ArraySupport other) {
  const auto place = [&](ArraySupport support) {
    return static_cast<std::size_t>(std::ranges::find(r.conditions->grid.support, support) -
                                    r.conditions->grid.support.begin());
  };
  const auto shear = [&](const Condition& at, ArraySupport support) {
    return over_orientations(r, {.number = HistoryNumber::base_shear},
                             at.with(ConditionAxis::support, place(support)), Periods::one)
        .median;
  };
  double largest = 0.0;
  for (const Condition& at : along(r.conditions->grid, ConditionAxis::period))
    largest = worse(largest, shear(at, ArraySupport::isolated) / shear(at, other));
  return largest;
}

Case base_shear_case(const Results& r) {
  return limit({"study 17, six periods, array isolated",
                "base shear over that with the array anchored", paper + "Fig. 16: lower"},
               {"largest ratio", largest_base_shear_ratio(r, ArraySupport::anchored), 1.0});
}

Case slope_case(const Results& r) {
  int falling = 0, pairs = 0;
  double before = 0.0;
  for (const Condition& at : along(r.conditions->grid, ConditionAxis::slope)) {
    const double now = median_m(r, at, Periods::largest);
    falling += now > before ? 0 : 1;
    ++pairs;
    before = now;
  }
  return all_equal({"study 18, slopes of 0.25 to 1.5 in 12", "displacement grows with the slope",
                    paper + "Fig. 17"},
                   {falling, pairs});
}

Case level_case(const Results& r) {
  const auto mean = [&](std::size_t suite) {
    return over_orientations(r, {.suite = suite}, {}, Periods::one).median;
  };
  return within({"study 15, T = 0.2 s, mean over the suite", "Level 2 over Level 1",
                 paper + "Fig. 14: no significant movement below Level 2"},
                {"ratio", mean(2) / mean(1), 5.0, INFINITY});
}

Case mce_case(const Results& r) {
  return within(
      {"study 19", "MCE displacement at T = 0.2 s over the largest at DBE",
       paper + "Fig. 18: close"},
      {"ratio",
       median_m(r, last(r, ConditionAxis::level), Periods::one) / median_m(r, {}, Periods::largest),
       0.75, 1.33});
}

}  // namespace

Chapter second_paper_statements(const Folders& folders) {
  const AllResults all = run_all(folders);
  Chapter chapter{
      "9.7 The second paper: what it says",
      R"(Studies 14 to 21 repeat the examples of Walters et al. (2012). The cases are statements that can be
checked on built-in suites. The table has each statement beside our numbers. The suites of the paper
are not published except that of Level 2 (study 14; it needs the recorded motions), so numbers may
differ. One statement about a trend is not confirmed: that the base shear is lower than without an array
holds in study 17 at the three shorter periods only, so that it is no case.)",
      {}};
  for (const Case& c : {base_shear_case(all.at("17")), slope_case(all.at("18")),
                        level_case(all.at("15")), mce_case(all.at("19"))})
    chapter.cases.push_back(c);
  chapter.measured = "\n| study | where | Walters et al. (2012) | ours |\n|---|---|---|---|\n";
  for (const StatedStudy& study : stated_studies()) chapter.measured += rows(all, study);
  return chapter;
}

}  // namespace glissade::verification
