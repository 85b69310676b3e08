// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/pairing.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <sstream>
#include <tuple>

#include "glissade/core/error.hpp"
#include "glissade/core/printable.hpp"
#include "import/component_name.hpp"
#include "records/formats/reading.hpp"
#include "text/scan.hpp"

namespace glissade {
namespace {

constexpr std::size_t vertical_at = 2;

/// Letters and digits, lower case.
std::string plain_location(const std::string& location) {
  std::string plain = lower_case(location);
  std::erase_if(plain, [](unsigned char c) { return std::isalnum(c) == 0; });
  return plain;
}

/// As headers of CSMIP, CESMD and COSMOS write it: "FREEFIELD", "Free Field, 30 m W", "FF".
bool is_free_field(const std::string& location) {
  const std::string plain = plain_location(location);
  return plain == "ff" || plain.find("freefield") != plain.npos;
}

/// "Ground Level", "Surface"; not "Ground floor: center", which is of a structure.
bool is_ground_level(const std::string& location) {
  constexpr std::array names = {"ground", "groundlevel", "groundsurface", "surface", "grade"};
  return std::ranges::find(names, plain_location(location)) != names.end();
}

/// A component with what its header, the report and its name say of where it belongs.
struct ComponentPiece {
  std::size_t component;
  const FoundComponent* found;
  SplitName name = {};  ///< of its file
  std::optional<ComponentDirection> direction = {};
  const ReportRow* row = nullptr;
  std::optional<std::size_t> place_in_row = {};  ///< of its file in the row
  bool is_beside_structure = false;              ///< its station has channels of one
  /// Of its record; where that has too many components, the next.
  std::string key = {}, state = {}, narrow_key = {};
};
using Pieces = std::vector<ComponentPiece>;

/// Finds the row of a component.
class ReportIndex {
 public:
  explicit ReportIndex(const SearchReport* report) {
    if (report == nullptr) return;
    for (const ReportRow& row : report->rows) {
      if (!row.rsn.empty()) by_rsn_.emplace(row.rsn, &row);
      if (!row.event_id.empty()) by_event_.emplace(row.event_id + "|" + row.station, &row);
      for (const std::string& file : row.files)
        if (!file.empty()) by_file_.emplace(lower_case(file), &row);
    }
  }
  void look_up(ComponentPiece& piece) const {
    const std::string file = piece.found->file_name();
    const RecordHeader& header = piece.found->header;
    if (const auto named = by_file_.find(lower_case(file)); named != by_file_.end()) {
      piece.row = named->second;
      for (std::size_t i = 0; i < piece.row->files.size(); ++i)
        if (lower_case(piece.row->files[i]) == lower_case(file)) piece.place_in_row = i;
    } else if (const auto rsn = by_rsn_.find(record_sequence_number(file)); rsn != by_rsn_.end()) {
      piece.row = rsn->second;
    } else if (const auto event = by_event_.find(header.event_id + "|" + header.station);
               event != by_event_.end()) {
      piece.row = event->second;
    }
  }

 private:
  std::map<std::string, const ReportRow*> by_rsn_, by_event_, by_file_;
};

std::optional<ComponentDirection> direction_of(const ComponentPiece& piece) {
  if (piece.place_in_row == vertical_at) {
    auto direction = component_direction(piece.found->header.direction);
    return direction && direction->is_vertical ? direction : ComponentDirection{true, false, {}, 0};
  }
  auto direction = component_direction(piece.found->header.direction);
  if (direction && piece.place_in_row) {
    direction->is_vertical = false;
    direction->order = static_cast<int>(*piece.place_in_row) + 1;
  }
  if (direction) return direction;
  if (piece.place_in_row)
    return ComponentDirection{false, false, {}, static_cast<int>(*piece.place_in_row) + 1};
  return std::nullopt;
}

/// Whether a name's end, which could be a direction, is none: the header states another.
bool is_other(const std::optional<ComponentDirection>& by_name,
              const std::optional<ComponentDirection>& stated) {
  constexpr double tolerance_deg = 5.0;
  return by_name && stated && by_name->azimuth_deg &&
         (!stated->azimuth_deg ||
          std::abs(std::remainder(*by_name->azimuth_deg - *stated->azimuth_deg, 180.0)) >
              tolerance_deg);
}

ComponentPiece piece_of(std::size_t component, const FoundComponent& found,
                        const ReportIndex& report) {
  ComponentPiece piece{component, &found};
  const bool is_one_of_several = !found.address.empty();
  const std::string stem = stem_of(found.file_name());
  report.look_up(piece);
  piece.direction = direction_of(piece);
  piece.name = is_one_of_several ? SplitName{stem, ""} : split_direction(stem, piece.direction);
  if (is_other(component_direction(piece.name.direction), piece.direction))
    piece.name = {stem, ""};  // "CHB0021412312349.EW" is a time
  const std::string folder = found.member.empty()
                                 ? found.file.parent_path().string()
                                 : (found.file / found.member).parent_path().string();
  const RecordHeader& header = found.header;
  piece.narrow_key = folder + "|" + (is_one_of_several ? found.file_name() : piece.name.rest);
  if (!header.location.empty()) piece.narrow_key = "at|" + lower_case(header.location);
  piece.state = !header.is_processed ? "" : *header.is_processed ? "processed" : "raw";
  if (piece.row != nullptr)
    piece.key =
        fmt::format("row|{}|{}|{}", piece.row->rsn, piece.row->event_id, piece.row->station);
  else if (!header.event.empty() && !header.station.empty())
    piece.key = fmt::format("header|{}|{}|{}", record_sequence_number(found.file_name()),
                            lower_case(header.event), lower_case(header.station));
  else
    piece.key = fmt::format("name|{}|{}", piece.narrow_key, lower_case(header.station));
  return piece;
}

std::string path_of(const ComponentPiece& piece) {
  return piece.found->file.string() + piece.found->whole_address();
}

std::string listed(const Pieces& pieces) {
  constexpr std::size_t most = 6;
  std::string list;
  for (std::size_t i = 0; i < std::min(most, pieces.size()); ++i)
    list += (i == 0 ? "" : ", ") + pieces[i].found->shown();
  return pieces.size() > most ? fmt::format("{} and {} more", list, pieces.size() - most) : list;
}

bool is_vertical(const ComponentPiece& piece) {
  return piece.direction && piece.direction->is_vertical;
}

std::size_t horizontals(const Pieces& pieces) {
  return static_cast<std::size_t>(std::ranges::count_if(pieces, std::not_fn(is_vertical)));
}
bool is_one_record(const Pieces& pieces) {
  return horizontals(pieces) <= 2 && pieces.size() - horizontals(pieces) <= 1;
}

bool are_perpendicular(const ComponentPiece& one, const ComponentPiece& other) {
  constexpr double tolerance_deg = 5.0;
  const auto &first = one.direction->azimuth_deg, &second = other.direction->azimuth_deg;
  return !first || !second ||
         std::abs(std::abs(std::remainder(*first - *second, 180.0)) - 90.0) <= tolerance_deg;
}

constexpr const char* by_hand = "; write its [[record]] by hand: first, second, vertical";

std::string reason_against_direction(const ComponentPiece& piece, const Pieces& pieces) {
  const FoundComponent& found = *piece.found;
  if (piece.direction)
    return "a component of its record has no direction: " +
           std::ranges::find_if(pieces, [](const ComponentPiece& p) {
             return !p.direction;
           })->found->shown();
  return fmt::format(
      "nothing states which component it is{}{}",
      found.header.direction.empty()
          ? ""
          : fmt::format(", as {} is no direction", in_quotes(found.header.direction)),
      found.suggested_direction.empty()
          ? by_hand
          : fmt::format("; its name suggests {}: --directions-from-names takes it",
                        found.suggested_direction));
}

/// Why pieces of one station and event are no record, said of one of them; "" where they are one.
std::string reason_against(const ComponentPiece& piece, const Pieces& pieces,
                           const ImportOptions& options) {
  const char* way_on = options.roof ? "; name those of one motion: --roof 1,2" : by_hand;
  const std::size_t across = horizontals(pieces);
  if (std::ranges::any_of(pieces, [](const ComponentPiece& p) { return !p.direction; }))
    return reason_against_direction(piece, pieces);
  if (!is_one_record(pieces))
    return fmt::format(
        "one of {} horizontal and {} vertical components of one station and event ({}): which "
        "belong together is not stated{}",
        across, pieces.size() - across, listed(pieces), way_on);
  const char* its = piece.found->header.location.empty() ? "station, event and name"
                                                         : "station, event and location";
  if (across == 0) return fmt::format("no horizontal component is of its {}", its);
  if (across == 1 && !options.keep_single)
    return fmt::format("one horizontal component only is of its {}: --keep-single takes it{}", its,
                       options.roof ? "; or name channels of several locations: --roof 1,2" : "");
  if (across == 2 && !are_perpendicular(pieces[0], pieces[1]))
    return fmt::format("horizontals of {:g} and {:g} degrees, which are not perpendicular{}",
                       *pieces[0].direction->azimuth_deg, *pieces[1].direction->azimuth_deg,
                       way_on);
  const auto step = [](const ComponentPiece& p) { return p.found->dt_s; };
  const double shortest_s = std::ranges::min(pieces, {}, step).found->dt_s;
  for (const ComponentPiece& other : pieces) {
    const double ratio = step(other) / shortest_s;
    if (!options.resample && std::abs(ratio - std::round(ratio)) > 1e-6)
      return fmt::format(
          "steps of {:g} and {:g} s, one no multiple of the other: --resample interpolates",
          shortest_s, step(other));
  }
  return "";
}

/// Horizontals first, by their place in the report, H1 before H2, by azimuth; then the vertical.
void sort_pieces(Pieces& pieces) {
  std::ranges::sort(pieces, {}, [](const ComponentPiece& p) {
    const ComponentDirection d = p.direction.value_or(ComponentDirection{});
    return std::tuple(d.is_vertical, d.order, d.azimuth_deg.value_or(0.0), p.component);
  });
}

/// A value of a header, if it can be one.
double within(double value, double most) { return value > 0.0 && value <= most ? value : 0.0; }

void take_header(ImportedRecord& record, const RecordHeader& header) {
  if (record.event.empty()) record.event = header.event;
  if (record.station.empty()) record.station = header.station;
  if (record.magnitude == 0.0) {
    record.magnitude = within(header.magnitude, largest_magnitude);
    record.magnitude_kind = record.magnitude > 0.0 ? header.magnitude_kind : "";
  }
  if (record.distance_km == 0.0) {
    record.distance_km = within(header.epicentral_km, longest_distance_km);
    record.distance_kind = record.distance_km > 0.0 ? "epicentral" : "";
  }
  if (record.vs30_mps == 0.0) record.vs30_mps = within(header.vs30_mps, fastest_vs30_mps);
}

void take_row(ImportedRecord& record, const ReportRow& row) {
  record.event = row.event;
  if (!row.rsn.empty()) record.station = row.station;
  record.magnitude = row.magnitude;
  record.magnitude_kind = row.magnitude_kind;
  record.distance_km = row.distance_km;
  record.distance_kind = row.distance_kind;
  record.vs30_mps = row.vs30_mps;
  record.scale = row.scale;
}

void compare_lengths(ImportedRecord& record, const Pieces& pieces, const ImportOptions& options) {
  constexpr double most_apart_s = 1.0;
  const auto end_s = [](const ComponentPiece& p) {
    return p.found->dt_s * static_cast<double>(p.found->samples);
  };
  const auto [first, last] = std::ranges::minmax_element(pieces, {}, end_s);
  if (end_s(*first) == end_s(*last)) return;
  if (options.trim) {
    record.end_s = to_twelve_digits(end_s(*first));
  } else if (end_s(*last) - end_s(*first) > most_apart_s) {
    record.warnings.push_back(fmt::format(
        "{} ends at {:.4g} s, {} at {:.4g} s: zero from there on; --trim ends all there",
        first->found->shown(), end_s(*first), last->found->shown(), end_s(*last)));
  }
}

void compare_steps(ImportedRecord& record, const Pieces& pieces, const ImportOptions& options) {
  const auto step = [](const ComponentPiece& p) { return p.found->dt_s; };
  const auto [shortest, longest] = std::ranges::minmax_element(pieces, {}, step);
  if (options.resample && step(*shortest) < step(*longest)) record.step_s = step(*shortest);
}

/// Below the roof: of the ground, or where a structure meets it.
bool is_at_ground(const std::string& location) {
  const std::string lower = lower_case(location);
  return is_free_field(location) || is_ground_level(location) ||
         std::ranges::any_of(
             std::array{"ground", "free", "embankment", "base", "footing", "foundation"},
             [&](const char* word) { return lower.find(word) != lower.npos; });
}

void warn_of_names_and_locations(ImportedRecord& record, const Pieces& pieces, bool of_roof) {
  std::string suggested;
  std::set<std::string> locations;
  for (const ComponentPiece& piece : pieces) {
    if (piece.found->has_direction_of_name())
      suggested += (suggested.empty() ? "" : ", ") + piece.found->suggested_direction;
    locations.insert(piece.found->header.location);
  }
  if (!suggested.empty())
    record.warnings.push_back("directions that only the names of its files suggest: " + suggested);
  for (const std::string& location : locations)
    if (!of_roof && pieces.front().is_beside_structure && is_ground_level(location))
      record.warnings.push_back(in_quotes(location) +
                                " may be the base of the structure whose channels are left out");
    else if (of_roof && is_at_ground(location))
      record.warnings.push_back("a motion of the roof is taken at " + in_quotes(location) +
                                ", which is no roof");
  if (locations.size() > 1)
    record.warnings.push_back("its components are at several locations: " +
                              fmt::format("{}", fmt::join(locations, "; ")));
}

void warn_of_components(ImportedRecord& record, const Pieces& pieces, bool of_roof) {
  warn_of_names_and_locations(record, pieces, of_roof);
  if (record.station.ends_with(" borehole"))
    record.warnings.push_back("was recorded in a borehole: the surface moves more");
  for (const ComponentPiece& piece : pieces) {
    for (const std::string& fault : piece.found->faults)
      record.warnings.push_back(piece.found->shown() + ": " + fault);
    if (piece.direction->is_down)
      record.warnings.push_back(piece.found->shown() +
                                " is named down: it is read as it is, as up positive");
    const auto by_name = component_direction(piece.name.direction);
    if (by_name && by_name->is_vertical && !piece.direction->is_vertical)
      record.warnings.push_back(fmt::format("{}: its name says {}, its header {}",
                                            piece.found->shown(), in_quotes(piece.name.direction),
                                            in_quotes(piece.found->header.direction)));
  }
  if (pieces.front().row == nullptr) return;
  for (const std::string& file : pieces.front().row->files) {
    const bool is_there = std::ranges::any_of(pieces, [&](const ComponentPiece& p) {
      return lower_case(p.found->file_name()) == lower_case(file);
    });
    if (!file.empty() && !is_there)
      record.warnings.push_back("the report names " + in_quotes(file) +
                                ", which is not among the files");
  }
}

/// A to z, 0 to 9, and what does not act on a shell; unique.
std::string id_of(const ComponentPiece& piece, std::set<std::string>& taken) {
  constexpr std::size_t longest = 34;
  const RecordHeader& header = piece.found->header;
  const std::string name =
      header.location.empty() ? piece.name.rest : header.station + " " + header.location;
  std::string id;
  for (const char c : name.substr(0, longest)) {
    const bool is_plain = std::isalnum(static_cast<unsigned char>(c)) != 0 && (c & 0x80) == 0;
    id += is_plain || c == '.' || c == '-' || c == '_' ? c : '_';
  }
  while (!id.empty() && (id.back() == '_' || id.back() == '-' || id.back() == '.')) id.pop_back();
  if (id.empty()) id = "record";
  std::string unique = id;
  for (int number = 2; !taken.insert(unique).second; ++number)
    unique = fmt::format("{}_{}", id, number);
  return unique;
}

ImportedRecord record_of(const Pieces& pieces, const ImportOptions& options,
                         std::set<std::string>& ids) {
  ImportedRecord record;
  record.id = id_of(pieces.front(), ids);
  if (pieces.front().row != nullptr) take_row(record, *pieces.front().row);
  for (const ComponentPiece& piece : pieces) take_header(record, piece.found->header);
  std::size_t horizontal = 0;
  for (const ComponentPiece& piece : pieces)
    record.components[is_vertical(piece) ? vertical_at : horizontal++] = piece.component;
  compare_steps(record, pieces, options);
  compare_lengths(record, pieces, options);
  warn_of_components(record, pieces, options.roof.has_value());
  return record;
}

/// Without what is given twice, under two names or in two formats, and dead channels.
Pieces different_pieces(SuiteImport& found, const ReportIndex& report) {
  Pieces pieces;
  std::map<std::uint64_t, std::size_t> by_samples;
  const auto source = [](const FoundComponent& c) { return std::pair(c.file, c.member); };
  for (std::size_t i = 0; i < found.components.size(); ++i) {
    const FoundComponent& component = found.components[i];
    const std::string what = component.file.string() + component.whole_address();
    if (component.is_dead) {
      found.left_out.push_back({what, component.faults.empty() ? "all its samples have one value"
                                                               : component.faults.front()});
      continue;
    }
    const auto [same, is_new] = by_samples.try_emplace(component.samples_hash, i);
    if (is_new) {
      pieces.push_back(piece_of(i, component, report));
      continue;
    }
    const FoundComponent& first = found.components[same->second];
    found.left_out.push_back(
        {what, fmt::format("a duplicate: the same {} as {}",
                           first.sha256 == component.sha256 && source(first) != source(component)
                               ? "bytes"
                               : "samples",
                           first.file.string() + first.whole_address())});
  }
  return pieces;
}

std::map<std::string, Pieces> by_key(const Pieces& pieces, std::string ComponentPiece::*key) {
  std::map<std::string, Pieces> groups;
  for (const ComponentPiece& piece : pieces) groups[piece.*key].push_back(piece);
  return groups;
}

/// Records of PEER's report without files; a flatfile has all records of its data base.
void report_missing_records(const SearchReport& report, const Pieces& pieces, SuiteImport& found) {
  std::set<std::string> seen{""};
  for (const ComponentPiece& piece : pieces)
    seen.insert({piece.row == nullptr ? "" : piece.row->rsn,
                 record_sequence_number(piece.found->file_name())});
  std::vector<std::string> missing, wanted = report.searched_rsns;
  for (const ReportRow& row : report.rows) wanted.push_back(row.rsn);
  for (const std::string& rsn : wanted)
    if (seen.insert(rsn).second) missing.push_back("RSN" + rsn);
  if (missing.empty()) return;
  constexpr std::size_t most = 100;
  const std::size_t count = missing.size();
  missing.resize(std::min(count, most));
  found.left_out.push_back(
      {report.path.string(),
       fmt::format("{} of its records {} no file here: {}{}", count, count == 1 ? "has" : "have",
                   fmt::join(missing, ", "), count > most ? " ..." : "")});
}

/// Of records of one event and station with the same directions: those that are not processed
/// beside one that is are left out, others are warned of.
void compare_records(SuiteImport& found) {
  const auto directions = [&](const ImportedRecord& record) {
    std::set<std::string> names;
    for (const auto& at : record.components)
      if (at) names.insert(lower_case(found.components[*at].header.direction));
    return names;
  };
  const auto is_processed = [&](const ImportedRecord& record) {
    return found.components[*record.components[0]].header.is_processed;
  };
  std::map<std::tuple<std::string, std::string, std::set<std::string>>, std::vector<std::size_t>>
      groups;
  for (std::size_t i = 0; i < found.records.size(); ++i) {
    const ImportedRecord& record = found.records[i];
    if (!record.event.empty() && !record.station.empty())
      groups[{lower_case(record.event), lower_case(record.station), directions(record)}].push_back(
          i);
  }
  std::set<std::size_t> unprocessed;
  for (const auto& [key, group] : groups) {
    if (group.size() < 2) continue;
    const auto processed = std::ranges::find_if(
        group, [&](std::size_t i) { return is_processed(found.records[i]) == true; });
    const std::size_t first = processed == group.end() ? group.front() : *processed;
    for (const std::size_t i : group) {
      ImportedRecord& record = found.records[i];
      if (i == first) continue;
      if (processed != group.end() && is_processed(record) == false) {
        unprocessed.insert(i);
        for (const auto& at : record.components)
          if (at)
            found.left_out.push_back(
                {found.components[*at].file.string() + found.components[*at].whole_address(),
                 "is not processed; " + found.records[first].id +
                     " is the same record, processed: to take this one import it alone"});
      } else {
        record.warnings.push_back("is of the same event and station as " + found.records[first].id +
                                  ": two such records are not independent");
      }
    }
  }
  std::vector<ImportedRecord> kept;
  for (std::size_t i = 0; i < found.records.size(); ++i)
    if (!unprocessed.contains(i)) kept.push_back(std::move(found.records[i]));
  found.records = std::move(kept);
}

/// The channels that a roof's option names: by their numbers, "7, 8", or by words of their
/// location, "roof".
class RoofChannels {
 public:
  explicit RoofChannels(const std::string& text) : words_(lower_case(single_blanks(text))) {
    if (text.find_first_not_of("0123456789, ") == std::string::npos) {
      std::string list = text;
      std::ranges::replace(list, ',', ' ');
      std::istringstream in(list);
      for (std::string number; in >> number;) numbers_.insert(number);
    }
    if (numbers_.empty() && trimmed(words_).empty())
      throw InputError({"--roof", "names no channel",
                        "give words of a location, --roof roof, or channels, --roof 7,8", ""});
  }
  bool are_numbers() const { return !numbers_.empty(); }
  bool have(const RecordHeader& header) const {
    if (header.location.empty()) return false;
    return are_numbers() ? numbers_.contains(header.channel)
                         : lower_case(header.location).find(trimmed(words_)) != std::string::npos;
  }
  /// Throws InputError where some name nothing.
  void check(const Pieces& pieces) const {
    const auto is_there = [&](const std::string& number) {
      return std::ranges::any_of(pieces, [&](const ComponentPiece& p) {
        return p.found->header.channel == number && !p.found->header.location.empty();
      });
    };
    for (const std::string& number : numbers_)
      if (!is_there(number))
        throw InputError({"--roof", "channel " + number + " is not among the files",
                          "give channels of these", channels_of(pieces)});
    if (std::ranges::none_of(pieces,
                             [&](const ComponentPiece& p) { return have(p.found->header); }))
      throw InputError({"--roof", "no channel's location has the words " + in_quotes(words_),
                        "give words of a location, or channels, of these", channels_of(pieces)});
  }

 private:
  static std::string channels_of(const Pieces& pieces) {
    std::string list;
    for (const ComponentPiece& p : pieces)
      if (const RecordHeader& h = p.found->header; !h.location.empty())
        list += fmt::format("{}channel {}, {}: {}", list.empty() ? "" : "\n", h.channel,
                            h.direction, h.location);
    return list.empty() ? "no file states a location" : list;
  }

  std::string words_;
  std::set<std::string> numbers_;
};

std::string channel_and_location(const RecordHeader& header) {
  return fmt::format("channel {} at {}", header.channel, in_quotes(header.location));
}

/// Those of the ground, or of a roof; the others are left out.
Pieces meant_pieces(const Pieces& pieces, const ImportOptions& options, SuiteImport& found) {
  std::optional<RoofChannels> roof;
  if (options.roof) {
    roof.emplace(*options.roof);
    roof->check(pieces);
  }
  std::set<std::string> stations_of_structures;
  for (const ComponentPiece& piece : pieces)
    if (piece.found->is_of_structure()) stations_of_structures.insert(piece.found->header.station);
  Pieces meant;
  for (const ComponentPiece& piece : pieces) {
    const RecordHeader& header = piece.found->header;
    if (roof ? roof->have(header) : !piece.found->is_of_structure()) {
      meant.push_back(piece);
      meant.back().is_beside_structure = stations_of_structures.contains(header.station);
      if (roof && roof->are_numbers()) meant.back().narrow_key = "numbered";
    } else if (header.location.empty()) {
      found.left_out.push_back(
          {path_of(piece), "states no location of a structure, as --roof requires"});
    } else {
      found.left_out.push_back(
          {path_of(piece), channel_and_location(header) +
                               (roof ? " is not of --roof"
                                     : " of a structure: --roof takes channels as a motion of its "
                                       "roof")});
    }
  }
  return meant;
}

}  // namespace

bool FoundComponent::is_of_structure() const {
  const std::string& at = header.location;
  return !at.empty() && !is_free_field(at) && !is_ground_level(at);
}

void pair_components(SuiteImport& found, const SearchReport* report, const ImportOptions& options) {
  const Pieces pieces = meant_pieces(different_pieces(found, ReportIndex(report)), options, found);
  std::set<std::string> ids;
  const auto take = [&](Pieces group) {
    sort_pieces(group);
    if (reason_against(group.front(), group, options).empty())
      found.records.push_back(record_of(group, options, ids));
    else
      for (const ComponentPiece& piece : group)
        found.left_out.push_back({path_of(piece), reason_against(piece, group, options)});
  };
  // Several versions of a record, of which one is not processed, are separated before names are
  // compared.
  const std::array narrower = {&ComponentPiece::key, &ComponentPiece::state,
                               &ComponentPiece::narrow_key};
  const std::function<void(const Pieces&, std::size_t)> divide = [&](const Pieces& group,
                                                                     std::size_t by) {
    for (const auto& [key, part] : by_key(group, narrower[by]))
      is_one_record(part) || by + 1 == narrower.size() ? take(part) : divide(part, by + 1);
  };
  divide(pieces, 0);
  if (report != nullptr) report_missing_records(*report, pieces, found);
  std::ranges::sort(found.records, {}, &ImportedRecord::id);
  compare_records(found);
}

}  // namespace glissade
