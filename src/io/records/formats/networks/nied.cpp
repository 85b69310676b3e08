// SPDX-License-Identifier: GPL-3.0-or-later
// K-NET and KiK-net of NIED, Japan: 17 lines with keys in columns 1 to 18, then counts; gal = count
// x scale factor, less the mean of the record ("K-NET ASCII format", kyoshin.bosai.go.jp/kyoshin,
// man/knetform.html and faq.html: the stated maximum is that of the record less its mean).
#include <fmt/format.h>

#include <cmath>

#include "records/formats/reading.hpp"

namespace glissade {
namespace {

constexpr std::size_t nied_key_width = 18, nied_header_lines = 17;

bool is_nied(const RecordText& file) {
  LineReader lines(file.text);
  if (!lines.next() || !lines.line().starts_with("Origin Time")) return false;
  while (lines.number() < nied_header_lines && lines.next())
    if (lines.line().starts_with("Scale Factor")) return true;
  return false;
}

/// m/s2 of a count: "3920(gal)/6182761".
double count_mps2(const RecordText& file, const HeaderLine& factor) {
  const std::string text = lower_case(factor.value);
  const auto gal = first_number(text);
  const std::size_t slash = text.find("(gal)/");
  const auto counts = slash == std::string::npos ? std::nullopt : first_number(text, slash + 6);
  if (!gal || !counts || !(gal->value > 0.0) || !(counts->value > 0.0))
    refuse_record(file.at(factor.line),
                  "the scale factor " + in_quotes(factor.value) + " is not as 3920(gal)/6182761",
                  "get the file again");
  return 0.01 * gal->value / counts->value;
}

/// A channel number is KiK-net's: 1 to 3 in the borehole, 4 to 6 at the surface; both have NS, EW,
/// UD.
struct NiedSensor {
  std::string name, place;
};
NiedSensor nied_sensor(const std::string& direction) {
  if (direction.size() != 1 || direction[0] < '1' || direction[0] > '6') return {direction, ""};
  constexpr const char* names[] = {"N-S", "E-W", "U-D"};
  const int channel = direction[0] - '1';
  return {names[channel % 3], channel < 3 ? " borehole" : " surface"};
}

std::vector<double> without_mean(std::vector<double> samples) {
  double sum = 0.0;
  for (const double a : samples) sum += a;
  const double mean = sum / static_cast<double>(samples.size());
  for (double& a : samples) a -= mean;
  return samples;
}

RecordHeader nied_header(const HeaderLines& lines, const std::string& where,
                         std::string direction) {
  const auto number = [&](const char* key) { return fortran_number(lines.value(key)); };
  RecordHeader header{lines.value("Origin Time"), lines.value("Station Code") + where,
                      std::move(direction), "counts x " + lines.value("Scale Factor")};
  state_magnitude(header, "Mag. " + lines.value("Mag."), {{"Mag.", "MJMA"}});
  header.epicentral_km = epicentral_km(number("Lat."), number("Long."), number("Station Lat."),
                                       number("Station Long."));
  header.is_processed = false;
  return header;
}

std::vector<FileComponent> read_nied(const RecordText& file, const RecordFileOptions& options) {
  LineReader lines(file.text);
  const HeaderLines header = HeaderLines::in_columns(lines, nied_key_width, nied_header_lines);
  const HeaderLine& factor = header.required(file, "Scale Factor");
  const HeaderLine& frequency = header.required(file, "Sampling Freq(Hz)");
  const HeaderLine& duration = header.required(file, "Duration Time(s)");
  const double unit_mps2 = count_mps2(file, factor);
  stated_unit(file, "gal", factor.line, options);  // which the options may not contradict
  const auto hz = first_number(frequency.value), length_s = first_number(duration.value);
  const double dt_s = stated_step(file.at(frequency.line), "1 / " + frequency.value,
                                  hz && hz->value > 0.0 ? 1.0 / hz->value : 0.0, options);
  std::vector<double> samples = read_rest(file, lines, unit_mps2);
  const double stated = length_s && hz ? std::round(length_s->value * hz->value) : 0.0;
  if (stated != static_cast<double>(samples.size()) || samples.empty())
    refuse_record(file.at(duration.line),
                  fmt::format("{} s at {} are {:g} values, the file contains {}", duration.value,
                              frequency.value, stated, samples.size()),
                  cut_short);
  const auto [name, where] = nied_sensor(header.value("Dir."));
  FileComponent component = file_component(file, name + where, dt_s, without_mean(samples),
                                           nied_header(header, where, plain_direction(name)));
  component.direction = name;
  component.record.notes.push_back((where.empty() ? "K-NET" : "KiK-net," + where) +
                                   ": not corrected, less its mean, as NIED states");
  return {std::move(component)};
}

}  // namespace

const RecordFormat nied_format{"K-NET or KiK-net", is_nied, read_nied};

}  // namespace glissade
