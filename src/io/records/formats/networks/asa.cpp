// SPDX-License-Identifier: GPL-3.0-or-later
// Archivo Estandar de Aceleracion 2.0 of the Instituto de Ingenieria, UNAM: "KEY : value" lines,
// those of channels "/V/N00E/N90E", then a column for each channel (3F10.4;
// aplicaciones.iingen.unam.mx/AcelerogramasRSM, as downloaded 2018).
#include <fmt/format.h>

#include "records/formats/reading.hpp"

namespace glissade {
namespace {

bool is_asa(const RecordText& file) {
  constexpr std::size_t looked_at = 1000;
  return lower_case(file.text.substr(0, looked_at)).find("archivo estandar de aceleracion") !=
         std::string::npos;
}

/// What stands behind a key; the second line of coordinates under "KEY 2".
std::vector<HeaderLine> asa_header(const RecordText& file, LineReader& lines) {
  std::vector<HeaderLine> header;
  while (lines.next()) {
    if (lines.line().starts_with("DATOS DE ACELERACION")) return header;
    auto line = line_with_colon(lines);
    if (!line) continue;
    if (line->key.empty() && !header.empty()) line->key = header.back().key + " 2";
    header.push_back(*std::move(line));
  }
  refuse_record(file, "ends before DATOS DE ACELERACION", cut_short);
}

/// "/V/N00E/N90E" as a line for each channel.
std::vector<HeaderLine> of_channels(const RecordText& file, const HeaderLine& list) {
  std::vector<HeaderLine> channels;
  for (std::size_t at = list.value.find('/'); at != std::string::npos;) {
    const std::size_t end = list.value.find('/', at + 1);
    channels.push_back(
        {list.key, std::string(trimmed(std::string_view(list.value).substr(at + 1, end - at - 1))),
         list.line});
    at = end;
  }
  if (channels.empty())
    refuse_record(file.at(list.line),
                  "its header does not state " + in_quotes(list.key) + " as /C1/C2/C3",
                  "the file is cut short or was edited: get it again");
  return channels;
}

/// "N90W;+" and "+V" without their signs.
std::string asa_direction(const std::string& name) {
  std::string plain = name.substr(0, name.find(';'));
  std::erase(plain, '+');
  return plain_direction(plain);
}

/// "16.84851 LAT. N" above "99.85157 LONG. W".
std::optional<double> coordinate_deg(const std::string& text) {
  const auto degrees = first_number(text);
  if (!degrees) return std::nullopt;
  return text.ends_with('S') || text.ends_with('W') ? -degrees->value : degrees->value;
}

RecordHeader asa_stated(const std::vector<HeaderLine>& header) {
  const auto value = [&](std::string_view key) { return line_beginning(header, key).value; };
  RecordHeader stated;
  stated.event = single_blanks(value("FECHA DEL SISMO") + " " + value("HORA EPICENTRO"));
  stated.station = value("NOMBRE DE LA ESTACION");
  state_magnitude(stated, value("MAGNITUD"),
                  {{"Mw", "Mw"}, {"Ms", "Ms"}, {"Mb", "mb"}, {"Mc", "Mc"}, {"M", "M"}});
  stated.epicentral_km = epicentral_km(coordinate_deg(value("COORDENADAS DEL EPICENTRO")),
                                       coordinate_deg(value("COORDENADAS DEL EPICENTRO 2")),
                                       coordinate_deg(value("COORDENADAS DE LA ESTACION")),
                                       coordinate_deg(value("COORDENADAS DE LA ESTACION 2")));
  return stated;
}

std::vector<FileComponent> read_asa(const RecordText& file, const RecordFileOptions& options) {
  LineReader lines(file.text);
  const std::vector<HeaderLine> header = asa_header(file, lines);
  const auto channels = of_channels(file, line_beginning(header, "ORIENTACION C1-C6")),
             steps = of_channels(file, line_beginning(header, "INTERVALO DE MUESTREO, C1-C6")),
             counts = of_channels(file, line_beginning(header, "NUM. TOTAL DE MUESTRAS, C1-C6"));
  if (steps.size() != channels.size() || counts.size() != channels.size())
    refuse_record(file.at(channels.front().line),
                  fmt::format("states {} channels, {} steps and {} counts", channels.size(),
                              steps.size(), counts.size()),
                  "the file was edited: get it again");
  const HeaderLine unit = line_beginning(header, "UNIDADES DE LOS DATOS");
  const double unit_mps2 = stated_unit(file, first_word(unit.value), unit.line, options);
  constexpr int lines_of_names = 4;  // rule, CANAL-1, V, rule
  for (int i = 0; i < lines_of_names && lines.next(); ++i) continue;

  std::vector<std::vector<double>> columns(channels.size());
  while (lines.next()) {
    std::vector<std::string_view> row;
    for (const std::string_view token : fields(lines.line()))
      for (const std::string_view number : touching_numbers(token)) row.push_back(number);
    if (!row.empty()) add_row(file, lines.number(), row, unit_mps2, columns);
  }
  std::vector<FileComponent> components;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const std::size_t stated = stated_count(file, counts[i]), found = columns[i].size();
    if (found > stated) columns[i].resize(stated);  // the last one is repeated
    check_stated_count(file.at(counts[i].line), stated, columns[i].size());
    const auto step = first_number(steps[i].value);
    const double dt_s = stated_step(file.at(steps[i].line), steps[i].value,
                                    step ? std::optional(step->value) : std::nullopt, options);
    RecordHeader of_channel = asa_stated(header);
    of_channel.direction = asa_direction(channels[i].value);
    of_channel.unit = first_word(unit.value);
    components.push_back(file_component(file, channels[i].value, dt_s, std::move(columns[i]),
                                        std::move(of_channel)));
    if (found > stated)
      components.back().record.notes.push_back(fmt::format(
          "the file has {} values and states {}: those behind are left out", found, stated));
  }
  return components;
}

}  // namespace

const RecordFormat asa_format{"ASA of UNAM", is_asa, read_asa};

}  // namespace glissade
