// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "records/at2_header.hpp"
#include "records/formats/record_format.hpp"
#include "records/record_units.hpp"
#include "records/time_column.hpp"
#include "text/scan.hpp"

// What the readers of all formats share. Files are untrusted: nothing is allocated by a number that
// a header states, and lists grow with what is read.
namespace glissade {

inline constexpr const char* what_is_read =
    "give a PEER AT2 file, one column of accelerations, or two columns time and acceleration, with "
    "# before comments; the other formats that are read are in suites/README.md";

inline constexpr const char* cut_short = "the file is cut short: get it again";

[[noreturn]] void refuse_record(const std::string& where, const std::string& what,
                                const std::string& suggestion);
[[noreturn]] void refuse_record(const RecordText& file, const std::string& what,
                                const std::string& suggestion);

/// InputError for a table of a spectrum or of modes, by the column that is no time.
[[noreturn]] void refuse_spectrum(const std::string& where, const std::string& column);

/// A number as Fortran, C or a spreadsheet writes it: also 1.5D-03. Blanks around it are dropped.
std::optional<double> fortran_number(std::string_view text);

/// The numbers of a token whose fields touch, as Fortran writes them ("1.5E+02-2.5E+03",
/// "1.50E+022.50E+03"); the token itself where it is one number, or none.
std::vector<std::string_view> touching_numbers(std::string_view token);

/// The fields of `width` characters, without what is blank at the end of the line.
std::vector<std::string_view> fixed_fields(std::string_view line, std::size_t width);

/// The width of the last Fortran format of a line: 10 of "Format=(8F10.5)"; 0: none.
std::size_t field_width(std::string_view line);

/// A finite number, or an InputError that names the token.
double parse_finite(const RecordText& file, std::size_t line, std::string_view token,
                    const char* what);
/// Up to most_samples.
void add_number(const RecordText& file, double value, std::vector<double>& values);
/// Adds a component of a file, which has up to most_samples in all of them.
void add_component(const RecordText& file, FileComponent component,
                   std::vector<FileComponent>& components);
/// Adds what a token states in units of so many m/s2.
void add_sample(const RecordText& file, std::size_t line, std::string_view token, double unit_mps2,
                std::vector<double>& samples_mps2);
/// A value of a binary file, by the same rules.
void add_value(const RecordText& file, double value, double unit_mps2,
               std::vector<double>& samples_mps2);

/// A block of samples in fixed fields.
struct SampleBlock {
  std::size_t count = 0;
  std::size_t width = 0;  ///< of a field; 0: numbers between blanks, which may touch
  double unit_mps2 = 1.0;
};
/// Reads a block from the lines that follow. InputError where the file ends before it does, or its
/// last line has more.
std::vector<double> read_block(const RecordText& file, LineReader& lines, const SampleBlock& block);
/// All numbers of the lines that follow.
std::vector<double> read_rest(const RecordText& file, LineReader& lines, double unit_mps2);
/// Pairs of time and acceleration, as a film was digitised.
struct TimedSamples {
  TimeColumn time;
  std::vector<double> samples_mps2;
};
/// Takes the fields of a line.
void add_pairs(const RecordText& file, std::size_t line, const std::vector<std::string_view>& row,
               double unit_mps2, TimedSamples& pairs);
/// Their step, or that of a header or of the options, with which they agree; a step other than
/// those between printed times is a note. InputError also where the times are those of a spectrum.
double step_of_rows(const RecordText& file, const TimedSamples& rows, const At2Header& stated,
                    const RecordFileOptions& options, std::vector<std::string>& notes);
/// InputError where the times are uneven, as most are.
double digitised_step_s(const RecordText& file, const TimedSamples& pairs,
                        const RecordFileOptions& options);

/// Adds the numbers of a row, each a sample of another component. InputError where they are more or
/// fewer.
void add_row(const RecordText& file, std::size_t line, std::span<const std::string_view> row,
             double unit_mps2, std::vector<std::vector<double>>& components);

/// What a header states by one of its keys.
struct HeaderLine {
  std::string key, value;
  std::size_t line = 0;  ///< 0: it does not
};
/// "KEY: value"; nothing without a colon.
std::optional<HeaderLine> line_with_colon(const LineReader& lines);
/// The first with a value whose key begins so; where there is none, the key alone.
HeaderLine line_beginning(const std::vector<HeaderLine>& header, std::string_view key);
class HeaderLines {
 public:
  /// "KEY: value" lines, up to the first line without a colon.
  static HeaderLines with_colons(LineReader& lines);
  /// Keys in the first `width` columns, or before a comma there; so many lines.
  static HeaderLines in_columns(LineReader& lines, std::size_t width, std::size_t count);
  /// nullptr: absent, or without a value.
  const HeaderLine* find(std::string_view key) const;
  std::string value(std::string_view key) const;  ///< "": absent
  /// InputError where the key is absent.
  const HeaderLine& required(const RecordText& file, std::string_view key) const;

 private:
  std::vector<HeaderLine> lines_;
};

/// A whole number from 1 to most_samples.
std::size_t stated_count(const RecordText& file, const HeaderLine& stated);
/// InputError unless a file holds as many samples as it states.
void check_stated_count(const std::string& where, std::size_t stated, std::size_t found);
void check_stated_count(const RecordText& file, const HeaderLine& stated, std::size_t found);
/// The step a header states, which `options` may mend, where it was printed with too few digits, by
/// 2 %.
double stated_step(const std::string& where, const std::string& text, std::optional<double> dt_s,
                   const RecordFileOptions& options);
double stated_step(const RecordText& file, const HeaderLine& stated,
                   const RecordFileOptions& options);
/// InputError unless a duration that a header states is that of its samples, to `tolerance_s` and
/// 2 %: otherwise its step or its count is wrong.
void check_duration(const std::string& where, double stated_s, double dt_s, std::size_t samples,
                    double tolerance_s);
/// m/s2 of the unit a header states; the options must agree.
double stated_unit(const RecordText& file, const std::string& text, std::size_t line,
                   const RecordFileOptions& options);
/// The same; one InputError where neither the unit nor the step is stated.
double stated_unit(const RecordText& file, const StatedUnit& unit, bool has_step,
                   const RecordFileOptions& options);

/// The first number in a text, and where the text goes on after it.
struct FoundNumber {
  double value;
  std::size_t end;
};
std::optional<FoundNumber> first_number(std::string_view text, std::size_t from = 0);

/// "" where there is none.
std::string first_word(std::string_view text);

/// The words of a text with one blank between them.
std::string single_blanks(std::string_view text);

/// InputError where no option states the unit of a format that has none.
void ask_for_unit(const RecordText& file, const char* format, const RecordFileOptions& options);

/// Throws InputError for a record without samples, and for accelerations that no ground has.
void check_readable(const Record& record);

/// "0" of "N-S", "280" of "N80W", "90" of "90 Deg" and "HNE", "UP" of "Up" and "U-D"; others as
/// they are. For comparing the components of a record.
std::string plain_direction(std::string_view direction);

/// A channel by SEED, "HNE", also with its location behind it, "BH100" (SEED 2.4, appendix A).
struct SeedChannel {
  char instrument;   ///< N an accelerometer (also L, G), H a seismometer, P a geophone
  char orientation;  ///< N, E, Z, or 1, 2, 3
};
std::optional<SeedChannel> seed_channel(std::string_view code);
/// InputError for the channel of a seismometer, of a file that does not say acceleration.
void refuse_seismometer(const RecordText& file, std::string_view channel);

/// What a line states of a channel: "Chan  2:  Up  (Sta Chn: 14)  Location: Roof, center".
struct ChannelLine {
  std::string name;       ///< "Chan 2: Up"
  std::string direction;  ///< "Up"
  std::string number;     ///< at the station, "14"
  std::string location;   ///< "Roof, center"
};
ChannelLine channel_line(std::string_view line);
/// States direction, number and location.
void take_channel(RecordHeader& header, const ChannelLine& channel);

/// The magnitude behind one of the names, "Mw=7.0" or "MOMENT MAG= 7.1": the first that has one,
/// with its kind.
struct MagnitudeName {
  std::string_view name;
  const char* kind;
};
void state_magnitude(RecordHeader& header, std::string_view line,
                     std::initializer_list<MagnitudeName> names);

/// Along the great circle; 0 where one of the four is absent or no place on earth.
double epicentral_km(std::optional<double> event_latitude_deg,
                     std::optional<double> event_longitude_deg,
                     std::optional<double> station_latitude_deg,
                     std::optional<double> station_longitude_deg);

/// Event, station and direction of a header are the source of its record.
FileComponent file_component(const RecordText& file, std::string name, double dt_s,
                             std::vector<double> samples_mps2);
FileComponent file_component(const RecordText& file, std::string name, double dt_s,
                             std::vector<double> samples_mps2, RecordHeader header);

}  // namespace glissade
