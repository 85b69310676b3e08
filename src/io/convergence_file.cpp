// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/io/convergence_file.hpp"

#include <algorithm>
#include <functional>

#include "convergence_names.hpp"
#include "hdf5_file.hpp"
#include "results_archive.hpp"
#include "results_envelope.hpp"
#include "shared_schema.hpp"

namespace glissade {
namespace {

constexpr ResultsKind kind{"glissade convergence", convergence_format_version,
                           "results file of a convergence study"};

// R is ConvergenceResults or const ConvergenceResults; so with the parts.

template <class Archive, class Scenes>
void exchange_scenes(const Archive& archive, Scenes& scenes) {
  make_rows(archive, "slope_deg", scenes);
  column(
      archive, "slope_deg", {"deg", "roof slope; positive falls toward +x"}, scenes,
      [](auto& s) -> auto& { return s.slope_deg; });
  column(
      archive, "friction", {"-", "coefficient of friction"}, scenes,
      [](auto& s) -> auto& { return s.mu; });
  column(
      archive, "ppa_g", {"g", "peak acceleration of the roof that the record is scaled to"}, scenes,
      [](auto& s) -> auto& { return s.ppa_g; });
}

template <class Archive, class Records>
void exchange_records(const Archive& archive, Records& records) {
  exchange_identity(archive, records);
  column(
      archive, "samples", {"-", "number of samples"}, records,
      [](auto& r) -> auto& { return r.samples; });
  column(
      archive, "pga_g", {"g", "peak acceleration of the component used, as recorded"}, records,
      [](auto& r) -> auto& { return r.pga_g; });
}

/// One field of every (record, scene).
template <class Archive, class R, class Field>
void sheet(const Archive& archive, const std::string& name, const Label& label, R& results,
           Field field) {
  std::vector<std::remove_cvref_t<decltype(field(results.exact.front()))>> values;
  if constexpr (!Archive::reads) {
    for (auto& slip : results.exact) values.push_back(field(slip));
  }
  Dims dims{results.records.size(), results.scenes.size()};
  archive.array(name, label, dims, values);
  if constexpr (Archive::reads) {
    if (dims != Dims{results.records.size(), results.scenes.size()})
      throw Hdf5Error("fit " + name + " to the records and scenes");
    results.exact.resize(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) field(results.exact[i]) = values[i];
  }
}

template <class Archive, class R>
void exchange_all(const Archive& archive, R& results) {
  archive.attribute("program_version", results.program_version);
  archive.attribute("plan_hash", results.plan_hash);
  archive.attribute("study", results.study_text);
  archive.attribute("study_name", results.study_name);
  archive.attribute("study_description", results.study_description);
  archive.attribute("suite_name", results.suite_name);
  archive.attribute("suite_description", results.suite_description);
  std::string component;
  if constexpr (!Archive::reads)
    component = name_of<HorizontalComponent>(component_names(), results.component);
  archive.attribute("component", component);
  if constexpr (Archive::reads)
    results.component = value_of<HorizontalComponent>(component_names(), component);

  list(archive, "substeps", {"-", "P: parts a sample interval is cut into"}, results.substeps);
  exchange_scenes(archive.group("scenes"), results.scenes);
  exchange_records(archive.group("records"), results.records);
  cube(archive, "residual_m",
       {"m",
        "residual displacement in plan by the published scheme, by (record, scene, substeps); of "
        "free sliders that at the last sample"},
       results.residual_m);
  sheet(
      archive, "exact_residual_m", {"m", "the same by the exact solution, by (record, scene)"},
      results, [](auto& slip) -> auto& { return slip.residual_m; });
  sheet(
      archive, "exact_peak_m",
      {"m", "peak displacement in plan by the exact solution, by (record, scene)"}, results,
      [](auto& slip) -> auto& { return slip.peak_m; });
  sheet(
      archive, "uplift", {"-", "1 where the array lifted off, by (record, scene)"}, results,
      [](auto& slip) -> auto& { return slip.uplift; });
}

/// Every part is there for each record, scene and P: whoever goes through the results need not
/// look.
void check_shapes(const ConvergenceResults& results) {
  const Array3<double>& residual = results.residual_m;
  if (residual.rows != results.records.size() || residual.columns != results.scenes.size() ||
      residual.depth != results.substeps.size())
    throw Hdf5Error("fit residual_m to the records, scenes and substeps");
  if (results.records.empty() || results.scenes.empty())
    throw Hdf5Error("find a record and a scene");
  const std::vector<int>& p = results.substeps;
  if (p.size() < 2 || p.front() < 1 ||
      std::adjacent_find(p.begin(), p.end(), std::greater_equal<>()) != p.end())
    throw Hdf5Error("take the substeps, which must rise");
}

}  // namespace

void write_convergence(const std::filesystem::path& file, const ConvergenceResults& results) {
  write_results_of(kind, file, [&](const Hdf5Writer& root) { exchange_all(root, results); });
}

bool is_convergence_results(const std::filesystem::path& file) { return is_results_of(kind, file); }

ConvergenceResults read_convergence(const std::filesystem::path& file) {
  ConvergenceResults results;
  read_results_of(kind, file, [&](const Hdf5Reader& root) {
    exchange_all(root, results);
    check_shapes(results);
  });
  return results;
}

}  // namespace glissade
