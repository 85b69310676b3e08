// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/io/suite_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <tuple>

#include "glissade/core/error.hpp"
#include "glissade/io/record_file.hpp"
#include "glissade/io/sha256.hpp"
#include "glissade/motion/record_edit.hpp"
#include "glissade/motion/sample_faults.hpp"
#include "keys/target_table.hpp"
#include "records/packed_files.hpp"
#include "suites/record_entry.hpp"
#include "suites/record_finder.hpp"
#include "text/scan.hpp"
#include "toml/toml_table.hpp"

namespace glissade {
namespace {

constexpr std::uint64_t largest_toml_integer = std::numeric_limits<std::int64_t>::max();

std::optional<DesignTarget> read_optional_target(const TomlTable& root) {
  const TomlTable table = root.table("target");
  if (!table.exists()) return std::nullopt;
  return read_target(table);
}

bool read_selection(const TomlTable& head) {
  return head.choice<bool>("selection", {{"nearest_to_target", true}}).value_or(false);
}

/// Ids name motions in results: each once.
void check_ids(const std::vector<TomlTable>& tables) {
  std::set<std::string> seen;
  for (const TomlTable& table : tables) {
    const auto id = table.text("id");
    if (id && !seen.insert(*id).second)
      table.report("id", "id \"" + *id + "\" is used twice", "give each its own id");
  }
}

/// A component with the step and the end that its record states.
Record edited(Record component, double start_s, const RecordEntry& entry) {
  if (entry.step_s) component = resampled(std::move(component), *entry.step_s);
  if (entry.end_s) component = ended_at(std::move(component), *entry.end_s - start_s);
  return component;
}

/// Azimuths that the suite states, else those of the files; a difference between them is found, and
/// that of the suite is taken.
MotionDirections directions_of(const RecordEntry& entry,
                               const std::array<TimedRecord*, 2>& horizontals,
                               std::vector<std::string>& found) {
  constexpr double most_apart_deg = 1.0;
  MotionDirections directions{{}, entry.strike_deg};
  for (std::size_t i = 0; i < horizontals.size(); ++i) {
    const char* key = i == 0 ? "first" : "second";
    if (horizontals[i] == nullptr) continue;
    Record& record = horizontals[i]->record;
    const auto stated = entry.components.at(key).azimuth_deg, of_file = stated_azimuth_deg(record);
    directions.horizontal_deg[i] = stated ? stated : of_file;
    if (!stated) continue;
    if (of_file ? std::abs(std::remainder(*stated - *of_file, 360.0)) > most_apart_deg
                : is_stated_vertical(record))
      found.push_back(fmt::format("azimuth_deg = {:g} of the {} component, whose file states {}",
                                  *stated, key,
                                  of_file ? shortest_decimal(*of_file) : "that it is vertical"));
    state_direction(record, shortest_decimal(*stated));
  }
  return directions;
}

/// Of the sources of its components, and of their samples.
std::vector<std::string> contradictions(const TimedRecord& first,
                                        const std::optional<TimedRecord>& second,
                                        const std::optional<TimedRecord>& vertical) {
  std::vector<std::string> found = source_contradictions(first, second, vertical);
  const auto add_faults = [&](const char* name, const Record& record) {
    const Samples& a = record.acceleration_mps2;
    for (const std::string& fault : sample_faults({a.data(), a.size()}))
      found.push_back(fmt::format("{} component: {}", name, fault));
  };
  add_faults("first", first.record);
  if (second) add_faults("second", second->record);
  if (vertical) add_faults("vertical", vertical->record);
  return found;
}

/// Of all components of a suite's motions together, 0.8 GB: 1,000 records of three components of
/// 160 s at 0.005 s.
constexpr std::size_t most_suite_samples = 100'000'000;

/// Reads the motions of a recorded suite, collecting what is missing, to report it together. A file
/// is read once, and its samples are shared, whatever the number of entries that name it.
class RecordedSuiteReader {
 public:
  /// @param units of files that do not state theirs
  RecordedSuiteReader(const std::filesystem::path& suite_file,
                      std::optional<AccelerationUnits> units, MotionProcessing processing)
      : suite_file_(suite_file),
        finder_(suite_file.parent_path()),
        units_(units),
        processing_(std::move(processing)) {}

  void read(const TomlTable& record, Suite& suite) {
    const std::size_t problems_before = record.problem_count();
    RecordEntry entry = read_record_entry(record);
    entry.processing = entry.processing.or_else(processing_);
    if (!record.has("first"))
      record.report_missing("first", "name the file of the first horizontal component");
    auto first = load(record, "first", entry);
    auto second = load(record, "second", entry);
    auto vertical = load(record, "vertical", entry);
    if (!first || record.problem_count() > problems_before) return;
    try {
      Motion metadata = entry.metadata;
      std::vector<std::string> of_azimuths;
      const MotionDirections directions =
          directions_of(entry, {&*first, second ? &*second : nullptr}, of_azimuths);
      metadata.contradictions = contradictions(*first, second, vertical);
      std::ranges::move(of_azimuths, std::back_inserter(metadata.contradictions));
      for (TimedRecord* component :
           {&*first, second ? &*second : nullptr, vertical ? &*vertical : nullptr})
        if (component != nullptr && entry.processing.baseline_degree)
          component->record =
              without_baseline(std::move(component->record), *entry.processing.baseline_degree);
      suite.motions.push_back(
          processed(assemble_motion(std::move(metadata), *first, second, vertical),
                    entry.processing, directions));
    } catch (const InputError& error) {
      return record.report("", error);
    }
    const Motion& motion = suite.motions.back();
    const auto& [x, y] = motion.horizontal_mps2;
    samples_ += x.size() + y.size() + motion.vertical_mps2.size();
    check_room(0, motion.id);
  }

  void report_missing(TomlDocument& document) const {
    if (missing_.empty()) return;
    constexpr std::size_t most = 6;
    std::string list;
    for (std::size_t i = 0; i < std::min(most, missing_.size()); ++i)
      list += (list.empty() ? "  " : "\n  ") + missing_[i];
    if (missing_.size() > most) list += fmt::format("\n  and {} more", missing_.size() - most);
    document.add(
        {suite_file_.string(),
         fmt::format("{} record file(s) not found: {}", missing_.size(), finder_.searched()),
         "set GLISSADE_RECORDS to the folders that hold them, separated by colons: "
         "recorded motions are licensed by their sources and do not come with glissade",
         list});
  }

 private:
  /// Throws InputError where the suite's samples, with as many more, are too many.
  void check_room(std::size_t more, const std::string& id) const {
    if (samples_ + more <= most_suite_samples) return;
    throw InputError({suite_file_.string(),
                      fmt::format("has more than {} million samples in all components of its "
                                  "records, from record {} on",
                                  most_suite_samples / 1'000'000, in_quotes(id)),
                      "name fewer records: the levels scale each of them", ""});
  }

  std::optional<RecordFinder::Found> find(const TomlTable& record, const char* key,
                                          const std::string& name) {
    try {
      auto found = finder_.find_component(name);
      if (!found) missing_.push_back(name);
      return found;
    } catch (const InputError& error) {
      record.report(key, error);
      return std::nullopt;
    }
  }

  struct ReadFile {
    std::optional<Record> record;  ///< nothing where it cannot be read, which is reported once
    std::string sha256;
  };

  /// The record in a file, which is read once.
  const ReadFile& read_once(const std::filesystem::path& path, const ComponentEntry& entry,
                            const TomlTable& record, const char* key) {
    std::error_code unknown;
    const std::filesystem::path real = std::filesystem::weakly_canonical(path, unknown);
    const auto [found, is_new] =
        read_.try_emplace({unknown ? path : real, entry.options.component, entry.options.dt_s,
                           entry.options.units, entry.options.counts_per_unit});
    ReadFile& read = found->second;
    const bool is_to_be_hashed = !entry.sha256.empty() && read.sha256.empty();
    if (!is_new && !is_to_be_hashed) return read;
    std::optional<RecordStore::Found> bytes;
    try {
      bytes = store_.find(path, entry.options.component);
    } catch (const InputError& error) {
      record.report(key, error);
      return read;
    }
    if (is_to_be_hashed) read.sha256 = sha256_of(*bytes->bytes);
    if (!is_new) return read;
    // No sample takes less than a digit and what separates it from the next.
    check_room(std::min(bytes->bytes->size() / 2, most_samples), record.text("id").value_or(""));
    try {
      read.record = read_record(*bytes, entry.options);
    } catch (const InputError& error) {
      record.report(key, error);
    }
    return read;
  }

  /// Reports a file whose bytes are not those that the suite was made with.
  static void check_sha256(const ReadFile& read, const ComponentEntry& entry,
                           const TomlTable& record, const char* key) {
    if (entry.sha256.empty() || read.sha256.empty() || read.sha256 == entry.sha256) return;
    record.report(key,
                  fmt::format("{} is not the file that the suite was made with: its SHA-256 is {}",
                              entry.file, read.sha256),
                  "get that file again; or, where the new one is meant, import it or state its "
                  "sha256");
  }

  std::optional<TimedRecord> load(const TomlTable& record, const char* key,
                                  RecordEntry& of_record) {
    const std::size_t problems_before = record.problem_count();
    auto entry = read_component_entry(record, key);
    if (!entry || record.problem_count() > problems_before) return std::nullopt;
    of_record.components[key] = *entry;
    if (entry->azimuth_deg && key == std::string_view("vertical"))
      record.report(key, "azimuth_deg is of a horizontal component, and this is the vertical",
                    "leave it out");
    entry->options.units_if_not_stated = units_;
    const auto found = find(record, key, entry->file);
    if (!found) return std::nullopt;
    entry->options.component = found->component;
    const ReadFile& read = read_once(found->path, *entry, record, key);
    check_sha256(read, *entry, record, key);
    if (!read.record || record.problem_count() > problems_before) return std::nullopt;
    try {
      return TimedRecord{edited(*read.record, entry->start_s, of_record), entry->start_s};
    } catch (const InputError& error) {
      record.report(key, error);
      return std::nullopt;
    }
  }

  std::filesystem::path suite_file_;
  RecordFinder finder_;
  std::optional<AccelerationUnits> units_;
  MotionProcessing processing_;  ///< of records that do not state theirs
  std::vector<std::string> missing_;
  using Source = std::tuple<std::filesystem::path, std::string, std::optional<double>,
                            std::optional<AccelerationUnits>, std::optional<double>>;
  RecordStore store_;
  std::map<Source, ReadFile> read_;
  std::size_t samples_ = 0;  ///< of the motions so far
};

Suite read_recorded_suite(const std::filesystem::path& file, TomlDocument& document) {
  const TomlTable root = document.root();
  const TomlTable head = root.required_table("suite");
  Suite suite;
  suite.name = head.required_text("name");
  suite.description = head.text("description").value_or("");
  suite.nearest_to_target = read_selection(head);
  suite.of_roof = head.choice<bool>("motions", {{"ground", false}, {"roof", true}}).value_or(false);
  suite.target = read_optional_target(root);
  if (suite.of_roof && suite.target)
    root.report("target", "motions = \"roof\", and [target] is a spectrum of the ground",
                "leave out [target]: motions of a roof are used as they are");
  const std::vector<TomlTable> records = root.tables("record");
  if (records.empty())
    root.report_missing("record", "give [[record]] entries, or [simulation] and [[motion]]");
  RecordedSuiteReader reader(file, read_units(head), read_processing(root));
  for (const TomlTable& record : records) reader.read(record, suite);
  check_ids(records);
  reader.report_missing(document);
  document.finish();
  return suite;
}

// The ranges of a recipe: wide, and such that every motion is finite and made in reasonable time.
constexpr NumberRule magnitude_rule{
    "from 3 to 8.5", [](double x) { return x >= 3.0 && x <= 8.5; },
    "moment magnitudes of BSSA14, whose median spectra simulations are brought to"};
constexpr NumberRule distance_rule{"from 0.1 to 400",
                                   [](double x) { return x >= 0.1 && x <= 400.0; },
                                   "BSSA14 ends at 400 km, and nearer than 0.1 km is no distance"};
constexpr NumberRule vs30_rule{"from 100 to 2000",
                               [](double x) { return x >= 100.0 && x <= 2000.0; },
                               "soft soil to hard rock, in m/s"};
constexpr NumberRule step_rule{
    "from 0.001 to 0.05", [](double x) { return x >= 0.001 && x <= 0.05; },
    "the time to simulate grows with the square of the samples, and above 0.05 s frequencies that "
    "matter are lost"};
constexpr NumberRule factor_rule{"from 0.001 to 1000",
                                 [](double x) { return x >= 0.001 && x <= 1000.0; },
                                 "a factor beyond is a slip"};
constexpr NumberRule gain_frequency_rule{"from 0.001 to 1000",
                                         [](double x) { return x >= 0.001 && x <= 1000.0; },
                                         "no motion has such frequencies, in Hz"};

void read_gain(const TomlTable& gain, SyntheticRecipe& recipe) {
  recipe.gain_frequencies_hz =
      gain.numbers("frequency_hz", gain_frequency_rule).value_or(std::vector<double>{});
  recipe.horizontal_gain = gain.numbers("horizontal", factor_rule).value_or(std::vector<double>{});
  recipe.vertical_gain = gain.numbers("vertical", factor_rule).value_or(std::vector<double>{});
  const auto& f = recipe.gain_frequencies_hz;
  if (std::adjacent_find(f.begin(), f.end(), std::greater_equal<>()) != f.end()) {
    gain.report("frequency_hz", "simulation.gain.frequency_hz is not increasing");
  }
  if (f.empty()) {
    gain.report("frequency_hz", "simulation.gain.frequency_hz has no frequency",
                "give one at least; [1.0] with gains of [1.0] leaves motions as they are");
  }
  if (recipe.horizontal_gain.size() != f.size() || recipe.vertical_gain.size() != f.size()) {
    gain.report("frequency_hz", "frequency_hz, horizontal and vertical differ in length",
                "give one gain per frequency");
  }
}

SyntheticMotion read_synthetic_motion(const TomlTable& table) {
  SyntheticMotion motion;
  motion.id = table.required_text("id");
  motion.magnitude = table.required_number("magnitude", magnitude_rule);
  motion.distance_km = table.required_number("distance_km", distance_rule);
  motion.vs30_mps = table.required_number("vs30_mps", vs30_rule);
  motion.mechanism =
      table
          .choice<FaultMechanism>("mechanism", {{"strike_slip", FaultMechanism::strike_slip},
                                                {"reverse", FaultMechanism::reverse}})
          .value_or(motion.mechanism);
  motion.realization = table.whole("realization", 0, largest_toml_integer).value_or(0);
  motion.scale = table.number("scale", factor_rule).value_or(1.0);
  for (const char* key : {"mechanism", "realization"}) {
    if (!table.has(key)) table.report_missing(key);
  }
  return motion;
}

SyntheticRecipe read_recipe(TomlDocument& document) {
  const TomlTable root = document.root();
  const TomlTable head = root.required_table("suite");
  SyntheticRecipe recipe;
  recipe.name = head.required_text("name");
  recipe.description = head.text("description").value_or("");
  recipe.nearest_to_target = read_selection(head);
  recipe.target = read_target(root.required_table("target"));

  if (!recipe.target.period_s.empty())
    root.table("target").report("spectrum",
                                "simulated motions are not designed for a spectrum by points",
                                "give ss_g, s1_g and site_class, or sds_g and sd1_g");

  enum class Model { rezaeian_der_kiureghian_2010 };
  const TomlTable simulation = root.required_table("simulation");
  if (!simulation.has("model"))
    simulation.report_missing("model", "known is rezaeian_der_kiureghian_2010");
  simulation.choice<Model>("model",
                           {{"rezaeian_der_kiureghian_2010", Model::rezaeian_der_kiureghian_2010}});
  if (!simulation.has("seed")) simulation.report_missing("seed");
  recipe.seed = simulation.whole("seed", 0, largest_toml_integer).value_or(0);
  recipe.dt_s = simulation.number("dt_s", step_rule).value_or(recipe.dt_s);
  recipe.max_scale = simulation.number("max_scale", factor_rule).value_or(recipe.max_scale);
  if (const TomlTable gain = simulation.required_table("gain"); gain.exists())
    read_gain(gain, recipe);

  const std::vector<TomlTable> motions = root.tables("motion");
  if (motions.empty()) root.report_missing("motion", "give [[motion]] entries");
  for (const TomlTable& motion : motions) recipe.motions.push_back(read_synthetic_motion(motion));
  check_ids(motions);
  document.finish();
  return recipe;
}

}  // namespace

bool has_roof_motions(const std::filesystem::path& suite_file) {
  TomlDocument document(suite_file);
  const TomlTable root = document.root();
  const TomlTable head = root.table("suite");
  return head.exists() && head.text("motions") == "roof";
}

std::optional<StatedTarget> find_stated_target(const std::filesystem::path& file) {
  TomlDocument document(file);
  const TomlTable root = document.root();
  root.ignore_unknown();
  const TomlTable table = root.table(root.has("site") ? "site" : "target");
  if (!table.exists()) return std::nullopt;
  table.ignore_unknown();
  std::optional<DesignTarget> mapped;  // beside a spectrum: of a project, not for a suite
  StatedTarget stated{read_target(table, &mapped), {}};
  if (const auto spectrum = table.text("spectrum"))
    stated.spectrum_file = file.parent_path() / *spectrum;
  document.finish();
  return stated;
}

StatedTarget read_stated_target(const std::filesystem::path& file) {
  const auto stated = find_stated_target(file);
  if (!stated)
    throw InputError({file.string(), "has no [site] and no [target]",
                      "give a project or a suite file with one", ""});
  return *stated;
}

std::vector<RecordFile> record_files(const std::filesystem::path& suite_file) {
  TomlDocument document(suite_file);
  RecordFinder finder(suite_file.parent_path());
  std::vector<RecordFile> files;
  for (const TomlTable& record : document.root().tables("record")) {
    for (const char* key : {"first", "second", "vertical"}) {
      const auto entry = read_component_entry(record, key);
      const auto found = entry ? finder.find_component(entry->file) : std::nullopt;
      if (found)
        files.push_back(
            {record.text("id").value_or(""), key, entry->file, found->path, found->component});
    }
  }
  return files;
}

std::vector<std::string> sha256_of(const std::vector<RecordFile>& files) {
  RecordStore store;
  std::vector<std::string> all;
  for (const RecordFile& file : files)
    all.push_back(sha256_of(*store.find(file.path, file.inside).bytes));
  return all;
}

bool is_recipe(const std::filesystem::path& suite_file) {
  TomlDocument document(suite_file);
  return document.root().has("simulation");
}

SyntheticRecipe read_recipe(const std::filesystem::path& file) {
  TomlDocument document(file);
  return read_recipe(document);
}

Suite load_suite(const std::filesystem::path& file) {
  TomlDocument document(file);
  for (const char* other : {"project", "study"}) {
    if (document.root().has(other) && !document.root().has("record"))
      throw InputError({file.string(), fmt::format("is a {} file, not a suite", other),
                        "name a file of [[record]] entries (suites/README.md)", ""});
  }
  if (document.root().has("simulation")) return simulate_suite(read_recipe(document));
  return read_recorded_suite(file, document);
}

}  // namespace glissade
