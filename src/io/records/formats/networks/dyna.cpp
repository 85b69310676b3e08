// SPDX-License-Identifier: GPL-3.0-or-later
// ESM, ITACA and AFAD-TADAS: "KEY: value" lines, then the values ("DYNA 1.2", INGV: Luzi et al.
// 2016, Seismol. Res. Lett. 87; esm-db.eu, as downloaded 2023).
#include <algorithm>

#include "records/formats/reading.hpp"

namespace glissade {
namespace {

bool is_dyna(const RecordText& file) {
  if (!file.first_line().starts_with("EVENT_NAME:")) return false;
  LineReader lines(file.text);
  const HeaderLines header = HeaderLines::with_colons(lines);
  return header.find("NDATA") != nullptr || header.find("SAMPLING_INTERVAL_S") != nullptr;
}

void refuse_other_data(const RecordText& file, const HeaderLines& header) {
  const HeaderLine* type = header.find("DATA_TYPE");
  if (type == nullptr || lower_case(type->value) == "acceleration") return;
  refuse_record(file.at(type->line),
                "holds " + in_quotes(lower_case(type->value)) + ", not acceleration",
                "give the file of accelerations (...ACC.ASC)");
}

RecordHeader dyna_header(const HeaderLines& lines, std::string direction) {
  const auto number = [&](const char* key) {
    return std::max(0.0, fortran_number(lines.value(key)).value_or(0.0));
  };
  RecordHeader header{
      single_blanks(lines.value("EVENT_DATE_YYYYMMDD") + " " + lines.value("EVENT_TIME_HHMMSS")),
      lines.value("NETWORK") + "." + lines.value("STATION_CODE"), std::move(direction),
      lines.value("UNITS"), lines.value("EVENT_ID")};
  state_magnitude(header, "Mw=" + lines.value("MAGNITUDE_W") + " ML=" + lines.value("MAGNITUDE_L"),
                  {{"Mw=", "Mw"}, {"ML=", "ML"}});
  header.epicentral_km = number("EPICENTRAL_DISTANCE_KM");
  header.vs30_mps = number("VS30_M/S");
  if (const HeaderLine* processing = lines.find("PROCESSING"))
    header.is_processed = lower_case(processing->value) != "none";
  return header;
}

std::vector<FileComponent> read_dyna(const RecordText& file, const RecordFileOptions& options) {
  LineReader lines(file.text);
  const HeaderLines header = HeaderLines::with_colons(lines);
  refuse_other_data(file, header);
  const HeaderLine& step = header.required(file, "SAMPLING_INTERVAL_S");
  const HeaderLine& count = header.required(file, "NDATA");
  const HeaderLine* units = header.find("UNITS");
  const double unit_mps2 =
      stated_unit(file, header.value("UNITS"), units == nullptr ? 0 : units->line, options);
  const double dt_s = stated_step(file, step, options);
  std::vector<double> samples = read_rest(file, lines, unit_mps2);
  check_stated_count(file, count, samples.size());
  if (const HeaderLine* duration = header.find("DURATION_S"))
    if (const auto stated_s = fortran_number(duration->value))
      check_duration(file.at(duration->line), *stated_s, dt_s, samples.size(), 2.0 * dt_s);
  const std::string stream = header.value("STREAM");
  return {file_component(file, stream, dt_s, std::move(samples),
                         dyna_header(header, plain_direction(stream)))};
}

}  // namespace

const RecordFormat dyna_format{"ESM, ITACA or AFAD-TADAS", is_dyna, read_dyna};

}  // namespace glissade
