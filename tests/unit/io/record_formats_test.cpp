// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <zlib.h>

#include <cstring>

#include "glissade/core/file.hpp"
#include "glissade/core/units.hpp"
#include "glissade/io/record_file.hpp"
#include "problems.hpp"
#include "records/formats/record_format.hpp"
#include "temporary_folder.hpp"

namespace glissade {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const fs::path corpus = fs::path(GLISSADE_SOURCE_DIR) / "tests/fuzz/corpus/record";

/// What every file of the corpus that is named here holds at 0.01 s, as it was written by hand; its
/// other components are minus or half of it. The mean is zero.
const std::vector<double> made_up_mps2 = {0, 0.5, -1, 0.25, 2, -0.5, -0.75, -0.5};

struct Sample {
  const char *file, *component;
  double factor = 1.0;
  RecordFileOptions options = {};
};
const RecordFileOptions in_mps2{.dt_s = {}, .units = AccelerationUnits::mps2};
const RecordFileOptions in_cmps2{.dt_s = {}, .units = AccelerationUnits::cmps2};
const RecordFileOptions column_in_mps2{.dt_s = 0.01, .units = AccelerationUnits::mps2};
const RecordFileOptions in_counts{.dt_s = {},
                                  .units = AccelerationUnits::mps2,
                                  .units_if_not_stated = {},
                                  .component = {},
                                  .counts_per_unit = 1000.0};

const std::vector<Sample> samples = {
    {"at2_d_exponents.at2", ""},
    {"at2_touching.at2", ""},
    {"knet.txt", ""},
    {"knet.txt", "E-W"},
    {"knet.csv", "E-W"},
    {"kiknet_borehole.txt", "N-S borehole"},
    {"kiknet_surface.txt", ""},
    {"esm.asc", ""},
    {"esd.acc", ""},
    {"afad.txt", "N-S"},
    {"afad.txt", "2", -1},
    {"afad.txt", "u-d", 0.5},
    {"cosmos.v2", "1"},
    {"cosmos.v2", "90 deg", -1},
    {"csmip.v2", "Chan 1: 360 Deg"},
    {"csmip.v2", "Up", 0.5},
    {"csmip_rate.v1", "360 Deg"},
    {"csmip_rate.v1", "2", 0.5},
    {"csmip_no_format.raw", ""},
    {"smc.smc", ""},
    {"smc_unknown.smc", "", 1, in_cmps2},
    {"smc_pairs.smc", ""},
    {"usc.dat", ""},
    {"usc_corrected.dat", "N08W"},
    {"cdmg_pairs.raw", "90 DEG"},
    {"cdmg_pairs.raw", "up", 0.5},
    {"renadic.v1", "L"},
    {"renadic.v1", "T", -1},
    {"renadic.v1", "V", 0.5},
    {"asa.txt", "N00E"},
    {"asa.txt", "N90W;", -1},
    {"asa.txt", "+V", 0.5},
    {"bhrc.v1", "L1"},
    {"bhrc.v1", "V1", 0.5},
    {"geonet.v1a", "N10E"},
    {"geonet.v1a", "Up", 0.5},
    {"csmnc.dat", ""},
    {"cwb.dat", "U", 0.5},
    {"cwb.dat", "N"},
    {"sac_little.sac", "", 1, in_mps2},
    {"sac_big.sac", "HNE", 1, in_mps2},
    {"bbp.txt", "N-S"},
    {"bbp.txt", "U-D", 0.5},
    {"opensees.out", "2", -1, in_mps2},
    {"seismosignal.txt", ""},
    {"eqsig.txt", "", 1, in_mps2},
    {"count_and_step.txt", "", 1, in_mps2},
    {"deepsoil.txt", "", 1, in_mps2},
    {"etabs.csv", "Accel"},
    {"sap.txt", "U3", 0.5},
    {"semicolon_decimal_comma.csv", "", 1, in_mps2},
    {"bom_crlf_ms.csv", "U1"},
    {"bom_crlf_ms.csv", "a [m/s^2]", -1},
    {"utf16.csv", "2", -1},
    {"latin1.csv", "Beschleunigung"},
    {"quoted_heading.csv", ""},
    {"decimal_comma_column.txt", "", 1, column_in_mps2},
};

Record read_sample(const Sample& sample) {
  RecordFileOptions options = sample.options;
  options.component = sample.component;
  return read_record(corpus / sample.file, options);
}

void expect_made_up(const Sample& sample, const Record& record) {
  const std::string name = std::string(sample.file) + "#" + sample.component;
  EXPECT_NEAR(record.dt_s, 0.01, 1e-15) << name;
  ASSERT_EQ(record.acceleration_mps2.size(), made_up_mps2.size()) << name;
  for (std::size_t i = 0; i < made_up_mps2.size(); ++i)  // as they print: g/10 with three decimals
    EXPECT_NEAR(record.acceleration_mps2[i], sample.factor * made_up_mps2[i], 5e-4) << name;
}

TEST(record_formats, each_gives_the_samples_that_its_file_was_written_from) {
  for (const Sample& sample : samples) {
    try {
      expect_made_up(sample, read_sample(sample));
    } catch (const InputError& error) {
      ADD_FAILURE() << sample.file << "#" << sample.component << ": " << error.what();
    }
  }
}

/// What the header of each component states.
std::vector<RecordHeader> headers_of(const fs::path& file, const RecordFileOptions& options = {}) {
  const std::string bytes = read_text_file(file);
  const RecordText text = record_text(file, bytes);
  std::vector<RecordHeader> headers;
  for (const FileComponent& component : format_of(text).read(text, options))
    headers.push_back(component.header);
  return headers;
}

// As CSMIP, CESMD and COSMOS write the channels of a structure.
TEST(record_formats, channels_of_a_structure_have_direction_number_and_location) {
  const auto stated = [](const std::string& file) {
    std::vector<std::string> channels;
    for (const RecordHeader& h : headers_of(corpus / file))
      channels.push_back(h.channel + "|" + h.direction + "|" + h.location);
    return channels;
  };
  EXPECT_THAT(stated("csmip.v2"),
              ElementsAre("14|360|DECK: MIDDLE OF SPAN, W. EDGE", "2|UP|Roof, center"));
  EXPECT_THAT(stated("cosmos.v2"), ElementsAre("1|340|", "2|90|Basement NW corner"));
  EXPECT_THAT(stated("renadic.v1"), ElementsAre("1|L|", "2|UP|", "3|T|"));
}

TEST(record_formats, components_of_two_locations_of_a_structure_are_named) {
  const TimedRecord deck{read_sample({"csmip.v2", "Chan 1: 360 Deg"}), 0.0},
      roof{read_sample({"csmip.v2", "Up"}), 0.0};
  EXPECT_THAT(source_contradictions(deck, {}, roof),
              ElementsAre(test::states("locations", "MIDDLE OF SPAN", "Roof, center")));
}

TEST(record_formats, miniseed_is_read_with_a_stated_gain) {
  const std::string message = message_of([] { read_record(corpus / "miniseed.mseed"); });
  if (message.find("libmseed") != std::string::npos) GTEST_SKIP() << message;
  EXPECT_THAT(message, test::states("counts", "counts_per_unit"));
  expect_made_up({"miniseed.mseed", "HNE"}, read_sample({"miniseed.mseed", "HNE", 1, in_counts}));
}

bool has_archives() {
  return message_of([] { read_record(corpus / "packed_knet.gz"); }).find("libarchive") ==
         std::string::npos;
}

TEST(record_formats, files_in_an_archive_are_addressed_by_their_path_in_it) {
  if (!has_archives()) GTEST_SKIP() << "built without libarchive";
  for (const Sample& sample : {Sample{"packed.zip", "records/etabs.csv#Accel"},
                               Sample{"packed.tar.gz", "records/etabs.csv#Accel"},
                               Sample{"packed.tar.gz", "sap.txt#U3", 0.5},
                               Sample{"packed_knet.gz", ""}, Sample{"packed_knet.gz", "E-W"}})
    expect_made_up(sample, read_sample(sample));
  EXPECT_THAT(message_of([] {
                read_sample({"packed.zip", "etabs.csv"});
              }),
              test::states("holds no file etabs.csv", "packed.zip#FILE"));
  EXPECT_THAT(message_of([] {
                read_sample({"packed.zip", "sap.txt#U9"});
              }),
              test::states("packed.zip#sap.txt", "'U9'", "U3"));
}

TEST(record_formats, members_that_lead_elsewhere_and_damaged_or_endless_archives_are_refused) {
  if (!has_archives()) GTEST_SKIP() << "built without libarchive";
  const auto message = [](const std::string& member) {
    return message_of([&] { read_sample({"improper.zip", member.c_str()}); });
  };
  for (const char* member : {"../out.csv", "/abs.csv", "link"})
    EXPECT_THAT(message(member), HasSubstr("holds no file")) << member;
  for (const char* member : {"good.csv#Accel", "inner.zip/etabs.csv#Accel"})
    expect_made_up({"etabs.csv", "Accel"}, read_sample({"improper.zip", member}));
  const TemporaryFolder folder;
  for (const char* name : {"packed.zip", "packed.tar.gz"}) {
    const std::string whole = read_text_file(corpus / name);
    const fs::path cut = folder.write("cut", whole.substr(0, whole.size() / 2));
    EXPECT_THAT(message_of([&] { read_record(cut); }), HasSubstr("cannot be unpacked")) << name;
  }
  const fs::path endless = folder.path() / "endless.gz";
  const gzFile out = gzopen(endless.c_str(), "wb1");
  const std::string zeros(std::size_t{1} << 20, '0');
  for (int i = 0; i < 257; ++i) gzwrite(out, zeros.data(), static_cast<unsigned int>(zeros.size()));
  gzclose(out);
  EXPECT_THAT(message_of([&] { read_record(endless); }), HasSubstr("more than 256 MiB"));
}

TEST(record_formats, what_is_missing_or_other_is_named) {
  const auto read = [](const std::string& name) { read_record(corpus / name); };
  expect_refusals(
      read, {{"afad.txt", "afad.txt", {"#1 (N-S)", "#2 (E-W)", "#3 (U-D)"}},
             {"opensees.out", "opensees.out", {"#1", "#3", "name one"}},
             {"sac_little.sac", "sac_little.sac", {"SAC", "give units"}},
             {"eqsig.txt", "eqsig.txt", {"units"}},
             {"semicolon_decimal_comma.csv", "semicolon_decimal_comma.csv", {"units"}},
             {"smc_unknown.smc", "smc_unknown.smc:1", {"UNKNOWN", "units"}},
             {"smc_velocity.smc", "smc_velocity.smc:1", {"velocity"}},
             {"csmip_spectra.v3", "csmip_spectra.v3", {"V3", "V2"}},
             {"station.xml", "station.xml", {"StationXML"}},
             {"usc_uneven.dat", "usc_uneven.dat:28", {"uncorrected", "0.02 to 0.033", "Volume II"}},
             {"smc_uneven.smc", "smc_uneven.smc:30", {"uncorrected", "0.02 to 0.033"}},
             {"uneven_heading.csv", "uneven_heading.csv:4", {"0.01 to 0.03"}},
             {"five_in_a_line.txt", "five_in_a_line.txt:1", {"5 columns", "NPTS="}},
             {"sap_two_joints.txt", "sap_two_joints.txt:11", {"'Joint'", "'12'", "'13'"}}});
}

TEST(record_formats, units_and_steps_that_contradict_the_header_are_refused) {
  for (const char* file : {"knet.txt", "esm.asc", "bbp.txt#1", "smc.smc", "etabs.csv"}) {
    const auto [name, component] = split_address(file);
    RecordFileOptions options = in_mps2;
    options.component = component;
    EXPECT_THAT(message_of([&] { read_record(corpus / name, options); }), HasSubstr("units says"))
        << file;
  }
  for (const char* file : {"knet.txt", "esm.asc", "esd.acc", "smc.smc", "etabs.csv"}) {
    EXPECT_THAT(message_of([&] { read_record(corpus / file, {.dt_s = 0.02, .units = {}}); }),
                HasSubstr("dt_s"))
        << file;
  }
}

TEST(record_formats, what_reading_changes_is_in_the_notes) {
  EXPECT_THAT(read_sample({"knet.txt", ""}).notes, ElementsAre(test::states("K-NET", "mean")));
  EXPECT_THAT(read_sample({"kiknet_borehole.txt", ""}).notes, ElementsAre(HasSubstr("borehole")));
  EXPECT_THAT(read_sample({"kiknet_surface.txt", ""}).notes, ElementsAre(HasSubstr("surface")));
  EXPECT_THAT(read_sample({"esm.asc", ""}).notes, IsEmpty());
  EXPECT_THAT(read_sample({"count_and_step.txt", "", 1, in_mps2}).notes,
              ElementsAre(HasSubstr("count")));
  const TemporaryFolder folder;
  const fs::path longer =
      folder.write("asa", read_text_file(corpus / "asa.txt") + "  9.0  9.0  9.0\n");
  const Record cut = read_record(longer, {.dt_s = {}, .units = {}, .component = "N00E"});
  EXPECT_EQ(cut.acceleration_mps2.size(), 8u);
  EXPECT_THAT(cut.notes, ElementsAre(test::states("9 values", "states 8")));
  const Record rounded = read_sample({"step_rounded.txt", "", 1, in_mps2});
  EXPECT_EQ(rounded.dt_s, 1.0 / 256);
  EXPECT_THAT(rounded.notes, ElementsAre(test::states("0.00390625", "0.0039")));
}

TEST(record_formats, components_of_surface_and_borehole_are_of_two_stations) {
  const TimedRecord surface{read_sample({"kiknet_surface.txt", ""}), 0.0},
      borehole{read_sample({"kiknet_borehole.txt", ""}), 0.0};
  EXPECT_THAT(source_contradictions(surface, borehole, {}), ElementsAre(HasSubstr("two stations")));
  const TimedRecord north{read_sample({"afad.txt", "N-S"}), 0.0},
      east{read_sample({"afad.txt", "E-W"}), 0.0}, up{read_sample({"afad.txt", "U-D"}), 0.0};
  EXPECT_THAT(source_contradictions(north, east, up), IsEmpty());
  EXPECT_THAT(message_of([&] { source_contradictions(up, {}, {}); }),
              test::states("afad.txt", "'UP'", "a vertical component, given as a horizontal one"));
  EXPECT_THAT(message_of([&] { source_contradictions(north, up, {}); }), HasSubstr("'UP'"));
  EXPECT_THAT(message_of([&] { source_contradictions(north, {}, east); }),
              test::states("'90'", "a horizontal component, given as the vertical one"));
}

TEST(record_formats, a_component_that_is_not_there_is_named_with_those_that_are) {
  for (const char* wanted : {"0", "4", "N", "360"}) {
    EXPECT_THAT(message_of([&] {
                  read_sample({"afad.txt", wanted});
                }),
                test::states("'" + std::string(wanted) + "'", "#3 (U-D)"));
  }
  EXPECT_THAT(message_of([] { read_sample({"esm.asc", "2"}); }), HasSubstr("#1 (HNE)"));
}

TEST(record_formats, an_address_is_a_file_and_a_component_unless_it_is_a_file) {
  const TemporaryFolder folder;
  const std::string file = folder.write("a#b.csv", "time_s,acc_g\n0,0.1\n0.01,0.2\n").string();
  EXPECT_EQ(split_address(file).component, "");
  EXPECT_EQ(split_address(file + "#acc").component, "acc");
  EXPECT_EQ(split_address(file + "#acc").file, file);
  EXPECT_EQ(split_address("floor.csv#U1").file, "floor.csv");
  EXPECT_EQ(split_address("floor.csv").component, "");
  EXPECT_EQ(split_address(file + "#x.csv#U1").component, "x.csv#U1");
}

/// The SAC file of the corpus with another channel, inclination, azimuth and quantity.
struct SacChannel {
  const char* name;
  float inclination_deg, azimuth_deg;
  std::int32_t quantity;
};
std::string sac_file(const SacChannel& channel) {
  std::string bytes = read_text_file(corpus / "sac_little.sac");
  const auto put = [&](std::size_t word, auto value) {
    std::memcpy(bytes.data() + 4 * word, &value, sizeof value);
  };
  put(57, channel.azimuth_deg);
  put(58, channel.inclination_deg);
  put(86, channel.quantity);
  bytes.replace(440 + 8 * 20, 3, channel.name);
  return bytes;
}

// SAC manual: CMPINC is from up, CMPAZ from north; -12345 is not stated; IDEP 8 is acceleration.
TEST(record_formats, the_header_of_sac_decides_the_component_and_else_its_channel) {
  constexpr float none = -12345.0F;
  constexpr std::int32_t acceleration = 8, unknown = 5;
  const TemporaryFolder folder;
  const auto file = [&](const SacChannel& c) { return folder.write("a.sac", sac_file(c)); };
  const auto direction = [&](const SacChannel& c) {
    return headers_of(file(c), in_mps2)[0].direction;
  };
  EXPECT_EQ(direction({"HNE", 90, 87, unknown}), "87");
  EXPECT_EQ(direction({"HN1", 90, 33.5F, unknown}), "33.5");
  for (const char* name : {"ENZ", "HGZ", "HNZ", "HLZ", "Q  "})
    EXPECT_EQ(direction({name, 0, 0, unknown}), "UP") << name;
  EXPECT_EQ(direction({"HNZ", 180, 0, unknown}), "DOWN");
  for (const char* name : {"ENZ", "HGZ", "HNZ"})
    EXPECT_EQ(direction({name, none, none, unknown}), "UP") << name;
  EXPECT_EQ(direction({"ENN", none, none, unknown}), "0");
  EXPECT_EQ(direction({"BHZ", 0, 0, acceleration}), "UP");
  const auto message = [&](const SacChannel& c) {
    return message_of([&] { read_record(file(c), in_mps2); });
  };
  for (const char* name : {"BHZ", "HHE", "EHN", "EPZ"})
    EXPECT_THAT(message({name, none, none, unknown}), test::states(name, "seismometer"));
  EXPECT_THAT(message({"HNE", 0, 0, unknown}), test::states("CMPINC = 0", "HNE"));
  EXPECT_THAT(message({"HNZ", 90, 0, unknown}), test::states("CMPINC = 90", "HNZ"));
  EXPECT_THAT(message({"HN1", 45, 0, unknown}), test::states("CMPINC = 45"));
}

TEST(record_formats, a_table_states_by_its_heading_that_a_seismometer_holds_accelerations) {
  const TemporaryFolder folder;
  const auto table = [&](const std::string& channel) {
    return folder.write("a.csv", "time (s)," + channel + "\n0.00,0.1\n0.01,-0.2\n0.02,0.1\n");
  };
  EXPECT_THAT(message_of([&] { read_record(table("BHZ"), in_mps2); }),
              test::states("BHZ", "seismometer", "unit in its heading"));
  EXPECT_TRUE(is_stated_vertical(read_record(table("BHZ (m/s2)"), {})));
}

TEST(record_formats, miniseed_of_a_seismometer_is_refused) {
  std::string bytes = read_text_file(corpus / "miniseed.mseed");
  const TemporaryFolder folder;
  const auto file = [&](const char* channel) {
    return folder.write("a.mseed", bytes.replace(15, 3, channel));
  };
  const std::string message = message_of([&] { read_record(file("HHE"), in_counts); });
  if (message.find("libmseed") != std::string::npos) GTEST_SKIP() << message;
  EXPECT_THAT(message, test::states("HHE", "seismometer"));
  EXPECT_EQ(headers_of(file("ENZ"), in_counts)[0].direction, "UP");
}

TEST(record_formats, two_steps_of_a_file_that_differ_are_refused) {
  const TemporaryFolder folder;
  const auto edited = [&](const char* name, const std::string& from, const std::string& to) {
    std::string text = read_text_file(corpus / name);
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << name;
    return folder.write(name, text.replace(at, from.size(), to));
  };
  const auto message = [](const fs::path& file) {
    return message_of([&] { read_record(file, {.dt_s = {}, .units = {}, .component = "1"}); });
  };
  EXPECT_THAT(message(edited("csmip.v2", "W. EDGE\ntext",
                             "W. EDGE\nAt equally-spaced intervals of  .020 sec.")),
              test::states("0.01 s", "0.02 s"));
  EXPECT_EQ(message(edited("csmip.v2", "W. EDGE\ntext",
                           "W. EDGE\nAt equally-spaced intervals of  .010 sec.")),
            "");
  EXPECT_THAT(message(edited("esm.asc", "NDATA:", "DURATION_S: 0.160\nNDATA:")),
              test::states("0.16 s", "0.08 s"));
  EXPECT_THAT(message(edited("cosmos.v2", "approx    0 secs", "approx   16 secs")),
              test::states("16 s", "0.08 s"));
}

// Real 62, in ms, is the step of the values; real 34 that of the recorder, before processing.
TEST(record_formats, the_step_of_cosmos_is_that_of_its_values) {
  std::string text = read_text_file(corpus / "cosmos.v2");
  constexpr std::size_t width = 13, in_a_line = 6, line_width = in_a_line * width + 1, real = 61;
  const std::size_t reals = text.find('\n', text.find("Real-header")) + 1;
  text.replace(reals + real / in_a_line * line_width + real % in_a_line * width, width,
               "     5.000000");
  const TemporaryFolder folder;
  const Record record =
      read_record(folder.write("a.v2", text), {.dt_s = {}, .units = {}, .component = "1"});
  EXPECT_EQ(record.dt_s, 0.005);
}

// A file that a program extended, or that was cut off by a system that failed.
TEST(record_formats, bytes_of_zero_behind_a_text_are_left_out_with_a_note) {
  const TemporaryFolder folder;
  const std::string text = "# units: g\n# DT = 0.01\n1\n2\n";
  const Record record = read_record(folder.write("a", text + std::string(300, '\0')));
  EXPECT_EQ(record.acceleration_mps2.size(), 2u);
  EXPECT_THAT(record.notes, ElementsAre(test::states("300 bytes of 0")));
  EXPECT_THAT(message_of([&] { read_record(folder.write("a", text + '\0' + "1\n")); }),
              HasSubstr("not a text"));
}

// By its heading, or by times that are none.
TEST(record_formats, a_spectrum_or_a_table_of_modes_is_refused_as_what_it_is) {
  const TemporaryFolder folder;
  const auto read = [&](const std::string& text) {
    read_record(folder.write("sa", text), column_in_mps2);
  };
  const std::string rows = "0.05,0.1\n0.10,0.2\n0.15,0.3\n",
                    three = "0.05\t0.1\t1\n0.10\t0.2\t1\n0.15\t0.3\t1\n";
  expect_refusals(
      read, {{"period_s,sa_g\n" + rows, "sa:2", {"'period_s'", "spectrum"}},
             {"T,PSA (g)\n" + rows, "sa:2", {"'T'", "spectrum"}},
             {"T [s],S_e [g]\n" + rows, "sa:2", {"'T [s]'", "spectrum"}},
             {"Time (s),PSA (g)\n" + rows, "sa:2", {"'Time (s)'", "spectrum"}},
             {"Tn (s),A (g)\n" + rows, "sa:2", {"'Tn (s)'", "spectrum"}},
             {"Schwingungszeit [s],Sa [g]\n" + rows, "sa:2", {"Schwingungszeit", "spectrum"}},
             {"Frequency (Hz),Amplitude (g)\n" + rows, "sa:2", {"'Frequency (Hz)'", "spectrum"}},
             {"Hz,acc_g\n" + rows, "sa:2", {"'Hz'", "spectrum"}},
             {"# Period (s), Sa (g)\n" + rows, "sa:1", {"Period (s)", "spectrum"}},
             {"Inelastic spectrum\n\n Period [sec]\t Acc./Elastic\t PS-Acc./Elastic\n" + three,
              "sa:4",
              {"'Period [sec]'", "spectrum"}},
             {"Mode,Period,UX,UY\n1,.5,.6,0\n2,.2,.2,.1\n", "sa:2", {"'Period'", "modes"}},
             {"0.01 0.1\n0.02 0.2\n0.05 0.3\n0.1 0.1\n", "sa:2", {"0.01 to 0.02", "spectrum"}},
             {"2 0.1\n1 0.2\n0.5 0.3\n", "sa:3", {"from 2 to 0.5", "spectrum"}},
             {"0.01 0.1\n0.02 -0.2\n0.05 0.3\n", "sa:2", {"0.01 to 0.02", "resample"}}});
  const fs::path rate = folder.write("sa", "# Sampling frequency (Hz), 100\n0,0.1\n0.01,0.2\n");
  EXPECT_EQ(read_record(rate, in_mps2).dt_s, 0.01);
}

// As people and programs write them above one column and two.
TEST(record_formats, lines_above_the_values_state_step_count_and_units) {
  const TemporaryFolder folder;
  for (const char* head :
       {"npts: 3\ndt: 0.005\nunits: g\n", "npts: 3\ndelta: 0.005\nunits: g\n",
        "Sampling rate: 200 Hz\nUnits: g\n", "Time step: 0.005 s\nAcceleration (g)\n",
        " SAMPLING RATE= 200Hz,\n UNIT  = g(9.8 m/s/s),\n",
        "# Sampling interval (ms) = 5\n# units: g\n", "dt=0.005\nacc: g\n"}) {
    for (const char* rows : {"1\n2\n-3\n", "0.000 1\n0.005 2\n0.010 -3\n"}) {
      if (std::string_view(head).ends_with("acc: g\n") && rows[1] == '.') continue;
      const fs::path file = folder.write("a.txt", head + std::string(rows));
      try {
        const Record record = read_record(file);
        EXPECT_NEAR(record.dt_s, 0.005, 1e-15) << head << rows;
        EXPECT_NEAR(record.acceleration_mps2.back(), -3 * standard_gravity_mps2, 1e-12) << head;
      } catch (const InputError& error) {
        ADD_FAILURE() << head << rows << error.what();
      }
      EXPECT_THAT(message_of([&] { read_record(file, {.dt_s = 0.01, .units = {}}); }),
                  test::states("0.005", "dt_s"))
          << head << rows;
    }
  }
  const auto read = [&](const std::string& text) { read_record(folder.write("a", text)); };
  expect_refusals(read,
                  {{"dt = 0.01\nSampling rate: 200 Hz\nunits: g\n1\n2\n", "a:2", {"two steps"}},
                   {"npts: 4\ndt: 0.005\nunits: g\n1\n2\n3\n", "a:1", {"4", "3"}}});
  // A station of PEER, and a name of a file.
  const fs::path delta = folder.write("a",
                                      "Imperial Valley, Delta, 262\ntest_dt0p01\nAcceleration in "
                                      "g\nNPTS= 2, DT= .02 SEC\n1 2\n");
  EXPECT_EQ(read_record(delta).dt_s, 0.02);
}

TEST(record_formats, units_and_step_that_are_both_missing_are_one_message) {
  const TemporaryFolder folder;
  for (const char* text : {"1\n2\n", "point\n1\n2\n", "EVENT\nNPTS= 2\n1 2\n"})
    EXPECT_THAT(problems_of([&] { read_record(folder.write("a", text)); }),
                one_problem("a", "units", "dt_s"))
        << text;
}

// Files are untrusted: whatever they were cut to, they are read or refused.
TEST(record_formats, a_file_cut_anywhere_is_refused_or_read) {
  const TemporaryFolder folder;
  for (const auto& entry : fs::directory_iterator(corpus)) {
    const std::string whole = read_text_file(entry.path());
    const std::size_t step = std::max<std::size_t>(1, whole.size() / 60);
    for (std::size_t length = 0; length < whole.size(); length += step) {
      const fs::path cut = folder.write("cut", whole.substr(0, length));
      for (const RecordFileOptions& options : {in_counts, column_in_mps2}) {
        try {
          EXPECT_FALSE(read_record(cut, options).acceleration_mps2.empty());
        } catch (const InputError& error) {
          EXPECT_THAT(error.problems().front().where, HasSubstr("cut")) << entry.path();
        }
      }
    }
  }
}

TEST(record_formats, a_file_without_its_last_value_is_refused_where_its_header_states_how_many) {
  const TemporaryFolder folder;
  for (const char* name :
       {"at2_touching.at2", "knet.txt", "kiknet_surface.txt", "esm.asc", "esd.acc", "afad.txt",
        "smc.smc", "usc.dat", "bhrc.v1", "asa.txt", "geonet.v1a", "csmnc.dat", "cwb.dat",
        "eqsig.txt", "deepsoil.txt", "knet.csv", "sac_little.sac"}) {
    const std::string whole = read_text_file(corpus / name);
    const bool is_binary = std::string_view(name).ends_with(".sac");
    const std::size_t end = is_binary ? whole.size() - 4 : whole.find_last_of("0123456789");
    const std::size_t token = is_binary ? end : whole.find_last_of(" \n", end);
    const fs::path cut = folder.write("cut", whole.substr(0, token));
    RecordFileOptions options = in_mps2;
    options.component = "1";
    if (message_of([&] { read_record(cut, options); }).find("units says") != std::string::npos)
      options.units.reset();
    EXPECT_THAT(message_of([&] { read_record(cut, options); }),
                testing::ContainsRegex("contain|ends after|columns|stated"))
        << name;
  }
}

TEST(record_formats, lines_may_end_with_a_carriage_return_and_headings_may_say_nothing) {
  const TemporaryFolder folder;
  EXPECT_EQ(read_record(folder.write("a", "time_s,acc_g\r0,1\r0.01,2\r")).dt_s, 0.01);
  EXPECT_EQ(read_record(folder.write("a", "points 3\nstep 0.01 s\n1\n2\n3\n"), column_in_mps2)
                .acceleration_mps2.size(),
            3u);
}

struct Heading {
  const char* text;
  double mps2;  ///< of 1
};
// As programs and people write them.
TEST(record_formats, headings_state_their_units_in_many_forms) {
  const TemporaryFolder folder;
  const double g = standard_gravity_mps2;
  for (const auto& [text, mps2] : std::vector<Heading>{{"Time (s),Accel (g)", g},
                                                       {"Time (sec)\tAcceleration (g's)", g},
                                                       {"t [s];a [m/s^2]", 1},
                                                       {"time_s,acc_gal", 0.01},
                                                       {"Time sec,U1 m/sec2", 1},
                                                       {"TIME,ACC in cm/s/s", 0.01},
                                                       {"Time\tAccel\nsec\tin/sec2", 0.0254},
                                                       {"time(s)  acc(mm/s**2)", 0.001},
                                                       {"Time [s],Acceleration [m/s\xc2\xb2]", 1},
                                                       {"Time [s],Acceleration [m/s\xb2]", 1},
                                                       {"Time (s),Sensor #1 (g)", g},
                                                       {"Time (s),Accel (ft/s^2)", 0.3048}}) {
    const std::string heading = text;
    const char separator = heading.find(';') != std::string::npos    ? ';'
                           : heading.find('\t') != std::string::npos ? '\t'
                           : heading.find(',') != std::string::npos  ? ','
                                                                     : ' ';
    const fs::path file = folder.write("table", fmt::format("{}\n0.00{}1\n0.02{}-1\n0.04{}0\n",
                                                            text, separator, separator, separator));
    try {
      const Record record = read_record(file);
      EXPECT_EQ(record.dt_s, 0.02) << text;
      EXPECT_NEAR(record.acceleration_mps2[0], mps2, 1e-12) << text;
    } catch (const InputError& error) {
      ADD_FAILURE() << text << ": " << error.what();
    }
  }
  expect_refusals([&](const std::string& text) { read_record(folder.write("table", text)); },
                  {{"Time (s),V (cm/s)\n0,1\n1,2\n2,3\n", "table:2", {"no column", "'V (cm/s)'"}},
                   {"Time (s),a (furlong)\n0,1\n1,2\n2,3\n", "table:1", {"furlong"}},
                   {"a (g),b (g)\n0,1\n1,2\n2,3\n", "table", {"#1 (a)", "#2 (b)"}},
                   {"Time (s),a (g)\n0,1\n1,2\n2\n", "table:4", {"1 columns", "2"}}});
}

}  // namespace
}  // namespace glissade
