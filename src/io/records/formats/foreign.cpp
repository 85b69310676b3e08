// SPDX-License-Identifier: GPL-3.0-or-later
// Files that are known and hold no acceleration this program reads: each is refused with what it is
// and with what to do.
#include <array>

#include "records/formats/reading.hpp"

namespace glissade {
namespace {

using namespace std::string_view_literals;

struct ForeignKind {
  std::string_view begins;    ///< the file does, or
  std::string_view contains;  ///< its first bytes, in lower case, do
  const char *what, *suggestion;
};

constexpr const char* to_text =
    "write the acceleration as text, CSV with a heading of names and "
    "units (ObsPy: read(FILE).write(..., format=\"TSPAIR\"))";
constexpr std::array foreign_kinds = {
    ForeignKind{"{", "", "is JSON, and no record", "leave it out"},
    ForeignKind{"", "<fdsnstationxml", "is StationXML, the metadata of a station, and no record",
                "give it to suite import, with the miniSEED files of its channels"},
    ForeignKind{"000001V ", "", "is a full SEED volume", "extract miniSEED (rdseed -d -o 4)"},
    ForeignKind{"MS\x03", "", "is miniSEED 3", to_text},
    ForeignKind{"\x89HDF", "", "is an HDF5 file (ASDF, results)", to_text},
    ForeignKind{"WID2", "", "is a GSE2 or IMS file", to_text},
    ForeignKind{"", "response and fourier amplitude spectra", "holds spectra (V3), and no motion",
                "give the file of accelerations, V2"},
    ForeignKind{"", "response spectra  ", "holds spectra (V3), and no motion",
                "give the file of accelerations, V2"},
};

/// SAC as text: 14 lines of five floats in 15 columns, 8 of five integers in 10, names, values.
bool is_sac_text(std::string_view text) {
  constexpr std::size_t integer_line = 15, name_line = 23;
  LineReader lines(text);
  std::size_t floats = 0, integers = 0;
  while (lines.number() < name_line - 1 && lines.next()) {
    const bool is_float = lines.number() < integer_line;
    const auto row = fields(lines.line());
    if (row.size() != 5 || !fortran_number(row.front())) return false;
    ++(is_float ? floats : integers);
  }
  return floats == 14 && integers == 8 && text.find("-12345") != std::string_view::npos;
}

const ForeignKind* foreign_kind(std::string_view text) {
  constexpr std::size_t looked_at = 1000;
  static constexpr ForeignKind sac_text{"", "", "is SAC as text (alphanumeric)",
                                        "write it as binary SAC (SAC: convert)"};
  const std::string beginning = lower_case(text.substr(0, looked_at));
  for (const ForeignKind& kind : foreign_kinds) {
    if (kind.contains.empty() ? text.starts_with(kind.begins)
                              : beginning.find(kind.contains) != std::string::npos)
      return &kind;
  }
  return is_sac_text(text) ? &sac_text : nullptr;
}

bool is_foreign(const RecordText& file) { return foreign_kind(file.text) != nullptr; }

std::vector<FileComponent> refuse_foreign(const RecordText& file, const RecordFileOptions&) {
  const ForeignKind& kind = *foreign_kind(file.text);
  refuse_record(file, kind.what, kind.suggestion);
}

}  // namespace

const RecordFormat foreign_format{"none that is read", is_foreign, refuse_foreign, true};

}  // namespace glissade
