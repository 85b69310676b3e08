// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/io/results_file.hpp"

#include <new>

#include "glissade/core/contract.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/file.hpp"
#include "results_schema.hpp"

namespace glissade {
namespace {

constexpr const char* file_type_name = "glissade results";

bool labels_are_distinct_names(const Results& results) {
  for (std::size_t i = 0; i < results.runs.size(); ++i) {
    const std::string& label = results.runs[i].label;
    if (label.empty() || label == "label" || label.find('/') != std::string::npos) return false;
    for (std::size_t j = 0; j < i; ++j) {
      if (results.runs[j].label == label) return false;
    }
  }
  return true;
}

std::string image_of(const Results& results) {
  const Hdf5Image image;
  {
    const Hdf5Writer root(image);
    root.attribute("file_type", std::string(file_type_name));
    root.attribute("format_version", std::uint64_t{results_format_version});
    exchange(root, results);
  }
  return image.bytes();
}

void check_type_and_version(const Hdf5Reader& root) {
  std::string file_type;
  root.attribute("file_type", file_type);
  if (file_type != file_type_name) throw Hdf5Error("take the file type " + file_type);
  std::uint64_t version = 0;
  root.attribute("format_version", version);
  if (version != results_format_version) {
    throw Hdf5Error("understand format version " + std::to_string(version) +
                    " (this program reads " + std::to_string(results_format_version) + ")");
  }
}

void expect_fit(bool fits, const char* part, const char* whole) {
  if (!fits) throw Hdf5Error(std::string("fit ") + part + " to the " + whole);
}

/// Every part is there for each record, sample, level and threshold that the others have: whoever
/// goes through the results need not look.
void check_shapes(const Results& results) {
  const std::size_t records = results.records.size(), samples = results.samples.size(),
                    levels = results.levels.size(), thresholds = results.thresholds_m.size();
  const auto is_cube = [&](const auto& cube, std::size_t depth) {
    return cube.rows == records && cube.columns == samples && cube.depth == depth;
  };
  for (const RunResults& run : results.runs) {
    expect_fit(is_cube(run.peak_displacement_m, levels), "peak_displacement_m",
               "records, samples and levels");
    expect_fit(is_cube(run.uplift, levels), "uplift", "records, samples and levels");
    expect_fit(is_cube(run.capacity, thresholds), "capacity_g", "records, samples and thresholds");
    expect_fit(run.slip.size() == levels, "slip", "levels");
    expect_fit(run.fragilities.size() == thresholds, "fragility", "thresholds");
    for (const ThresholdFragility& f : run.fragilities) {
      expect_fit(f.probability.size() == levels, "probability", "levels");
      expect_fit(f.probability_interval.size() == levels, "probability_low", "levels");
      expect_fit(f.record_recross.size() == records, "record_recross", "records");
      expect_fit(f.band.empty() || f.band.size() == run.band_intensities.size(), "band_low",
                 "band's intensities");
    }
  }
  const SuiteSpectra& spectra = results.spectra;
  const std::size_t periods = spectra.periods_s.size();
  expect_fit(spectra.srss_g.size() == records, "srss_g", "records");
  for (const std::vector<double>& srss : spectra.srss_g)
    expect_fit(srss.size() == periods, "srss_g", "periods");
  expect_fit(spectra.average_srss_g.size() == periods, "average_srss_g", "periods");
  expect_fit(spectra.target_g.empty() || spectra.target_g.size() == periods, "target_g", "periods");
}

}  // namespace

void write_results(const std::filesystem::path& file, const Results& results) {
  GLISSADE_EXPECTS(labels_are_distinct_names(results));
  const Hdf5Silence silence;
  std::string image;
  try {
    image = image_of(results);
  } catch (const Hdf5Error& error) {
    throw InputError(
        {file.string(),
         std::string("the results could not be put together: cannot ") + error.what(),
         "check that there is memory enough, or ask for fewer samples, levels or records", ""});
  }
  write_text_file(file, image);
}

Results read_results(const std::filesystem::path& file) {
  const Hdf5Silence silence;
  const auto fail = [&](const std::string& reason) {
    return InputError({file.string(), "is not a whole glissade results file: cannot " + reason,
                       "give a results file of `glissade run`, or run the study again", ""});
  };
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored))
    throw InputError({file.string(), "no such file", "check the path", ""});
  if (!std::filesystem::is_regular_file(file, ignored)) throw fail("read what is no ordinary file");
  try {
    const Hdf5Reader root(file);
    check_type_and_version(root);
    Results results;
    exchange(root, results);
    check_shapes(results);
    if (!labels_are_distinct_names(results)) throw Hdf5Error("tell the runs apart by their labels");
    return results;
  } catch (const Hdf5Error& error) {
    throw fail(error.what());
  } catch (const std::bad_alloc&) {
    throw fail("hold it in memory");
  }
}

}  // namespace glissade
