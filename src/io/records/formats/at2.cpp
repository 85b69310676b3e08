// SPDX-License-Identifier: GPL-3.0-or-later
// PEER NGA-West2, NGA-East and the older PEER Strong Motion Database: header lines, one of which
// has NPTS and DT, then any number of values a line (peer.berkeley.edu, as downloaded 2000 to
// 2020).
#include "records/at2_header.hpp"
#include "records/formats/reading.hpp"

namespace glissade {
namespace {

bool is_at2(const RecordText& file) { return find_at2_header(file.text).has_value(); }

std::vector<FileComponent> read_at2(const RecordText& file, const RecordFileOptions& options) {
  const At2Header header = *find_at2_header(file.text);
  const double unit_mps2 = stated_unit(file, header.units, header.units_line, options);
  const double dt_s = at2_step(file.path, header, options.dt_s);
  LineReader lines(file.text);
  while (lines.number() < header.lines && lines.next()) continue;
  std::vector<double> samples = read_rest(file, lines, unit_mps2);
  check_at2_count(file.path, header, samples.size());
  FileComponent component = file_component(file, "", dt_s, std::move(samples));
  component.record.source = header.source;
  return {std::move(component)};
}

}  // namespace

const RecordFormat at2_format{"PEER AT2", is_at2, read_at2};

}  // namespace glissade
