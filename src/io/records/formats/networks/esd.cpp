// SPDX-License-Identifier: GPL-3.0-or-later
// European Strong-Motion Database: "Key : value" lines, one that names quantity and unit, then
// values in 5E14.7 (Ambraseys et al. 2004, Internet-Site for European Strong-Motion Data).
#include "records/formats/reading.hpp"

namespace glissade {
namespace {

constexpr std::size_t esd_field_width = 14;

bool is_esd(const RecordText& file) {
  if (!file.first_line().starts_with("Event")) return false;
  LineReader lines(file.text);
  const HeaderLines header = HeaderLines::with_colons(lines);
  return header.find("Time Increment (s)") != nullptr && header.find("Number of Data") != nullptr;
}

std::vector<FileComponent> read_esd(const RecordText& file, const RecordFileOptions& options) {
  LineReader lines(file.text);
  const HeaderLines header = HeaderLines::with_colons(lines);
  const HeaderLine& step = header.required(file, "Time Increment (s)");
  const HeaderLine& count = header.required(file, "Number of Data");
  lines.next();  // "Accelaration time series in m/s/s", as it is spelt
  const std::string_view quantity = lines.line();
  const std::size_t in = quantity.rfind(" in ");
  const std::string unit(in == quantity.npos ? "" : trimmed(quantity.substr(in + 4)));
  const double unit_mps2 = stated_unit(file, unit, lines.number(), options);
  const double dt_s = stated_step(file, step, options);
  std::vector<double> samples =
      read_block(file, lines, {stated_count(file, count), esd_field_width, unit_mps2});
  const std::string direction = header.value("Orientation");
  RecordHeader stated{header.value("Event Date & Time"), header.value("Station Code / Name"),
                      plain_direction(direction), unit};
  if (header.find("Processing Info") != nullptr) stated.is_processed = true;
  return {file_component(file, direction, dt_s, std::move(samples), std::move(stated))};
}

}  // namespace

const RecordFormat esd_format{"European Strong-Motion Database", is_esd, read_esd};

}  // namespace glissade
