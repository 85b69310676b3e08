// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/io/record_file.hpp"

#include <fmt/format.h>

#include "glissade/core/error.hpp"
#include "glissade/core/input_file.hpp"
#include "glissade/core/units.hpp"
#include "glissade/motion/improbable.hpp"
#include "glissade/motion/intensity.hpp"
#include "records/formats/reading.hpp"
#include "records/packed_files.hpp"
#include "records/time_column.hpp"
#include "text/scan.hpp"

namespace glissade {

ComponentAddress split_address(const std::string& name) {
  const auto is_there = [](const std::string& path) {
    return std::filesystem::exists(status_of(path));
  };
  if (is_there(name)) return {name, ""};
  for (std::size_t mark = name.find('#', 1); mark != std::string::npos;
       mark = name.find('#', mark + 1)) {
    const std::string file = name.substr(0, mark);
    if (is_there(file) || name.find('#', mark + 1) == std::string::npos)
      return {file, name.substr(mark + 1)};
  }
  return {name, ""};
}

void check_readable(const Record& record) {
  if (record.acceleration_mps2.empty())
    refuse_record(record.name, "the file holds no samples", what_is_read);
  const double pga_g =
      peak_ground_acceleration_mps2(record.acceleration_mps2) / standard_gravity_mps2;
  if (pga_g > most_possible_g)
    refuse_record(record.name,
                  fmt::format("PGA of {:.3g} g: no ground has shaken with more than {:g} g", pga_g,
                              most_possible_g),
                  "check its units; a factor is the record's scale");
}

Record read_record(const std::filesystem::path& file, const RecordFileOptions& options) {
  RecordStore store;
  return read_record(store.find(file, options.component), options);
}

Record read_record(const RecordStore::Found& found, RecordFileOptions options) {
  const std::filesystem::path& file = found.path;
  if (options.dt_s) check_step(file.string(), shortest_decimal(*options.dt_s), *options.dt_s);
  options.component = found.component;
  const RecordText text = record_text(file, *found.bytes);
  const RecordFormat& format = format_of(text);
  std::vector<FileComponent> components = format.read(text, options);
  FileComponent& component = components[picked_component(file, components, options.component)];
  Record record = std::move(component.record);
  if (const std::string direction = stated_direction(component, format, file); !direction.empty())
    state_direction(record, direction);
  check_readable(record);
  return record;
}

}  // namespace glissade
