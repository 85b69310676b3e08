// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "glissade/io/record_file.hpp"
#include "glissade/io/record_header.hpp"

namespace glissade {

/// A record file in memory.
struct RecordText {
  std::filesystem::path path;
  /// In UTF-8, also of a file in UTF-16 or Latin-1; or bytes, of a binary file.
  std::string_view text;
  std::size_t zero_bytes = 0;                   ///< behind the end of a text, left out
  std::shared_ptr<const std::string> own = {};  ///< what `text` is in, where it was changed

  std::string at(std::size_t line) const;  ///< "file:line"; the file where 0, no line, is meant
  std::string_view first_line() const;
};

/// One component of a file; `floor.csv#U1` addresses it by a name, `floor.csv#1` by its position.
struct FileComponent {
  std::string name;       ///< "U1", "Chan 1: 360 Deg"; empty: the file does not name it
  std::string direction;  ///< another name of it: "360 Deg"; may be empty
  Record record;          ///< of a table, without samples where another column is asked for
  RecordHeader header = {};
  std::optional<double> counts_per_mps2 = std::nullopt;  ///< by the station's metadata
};

/// A kind of file. A reader throws InputError for what is wrong with a file of its kind.
struct RecordFormat {
  const char* name;
  bool (*matches)(const RecordText& file);  ///< by content, never by the file's name
  std::vector<FileComponent> (*read)(const RecordText& file, const RecordFileOptions& options);
  bool is_binary = false;  ///< its files are no text
};

// One source file each, in the folder of its family.
extern const RecordFormat sac_format, miniseed_format, foreign_format, nied_format, dyna_format,
    esd_format, afad_format, cosmos_format, csmip_format, smc_format, usc_format, bhrc_format,
    asa_format, geonet_format, cwb_format, csmnc_format, at2_format, headed_column_format,
    table_format, column_format;

/// The first that matches reads a file; the last matches any text.
std::span<const RecordFormat* const> record_formats();

/// As a spreadsheet or DOS leaves it: UTF-16, lines that end with \r alone, an end-of-file mark,
/// bytes of 0 behind the end. InputError for bytes that are no text and of no binary format.
/// @param bytes used as long as the text is
RecordText record_text(const std::filesystem::path& file, std::string_view bytes);
/// Throws InputError where the file is no text, and of no binary format.
const RecordFormat& format_of(const RecordText& record);

/// The component that is asked for, by its position or one of its names; with no `wanted` the only
/// one. InputError with the list of those there are.
std::size_t picked_component(const std::filesystem::path& file,
                             const std::vector<FileComponent>& components,
                             const std::string& wanted);

/// As the header states it; else by the name of the component, or by the scheme of names of the
/// network whose format it is; "" where none states it.
std::string stated_direction(const FileComponent& component, const RecordFormat& format,
                             const std::filesystem::path& file);

}  // namespace glissade
