// SPDX-License-Identifier: GPL-3.0-or-later
#include "record_folder.hpp"

namespace glissade {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Ten channels of a hall with a free field, a file each.
class StructureImporter : public SuiteImporter {
 protected:
  StructureImporter() {
    const std::vector<std::string> channels = {
        "Up        (Sta Chn:  1)     Location: Free field",
        "90 Deg    (Sta Chn:  2)     Location: Free field",
        "360 Deg   (Sta Chn:  3)     Location: Free field",
        "90 Deg    (Sta Chn:  4)     Location: Roof: center",
        "360 Deg   (Sta Chn:  5)     Location: Roof: N wall",
        "360 Deg   (Sta Chn:  6)     Location: Roof: S wall",
        "Up        (Sta Chn:  7)     Location: Roof: center",
        "90 Deg    (Sta Chn:  8)     Location: Mezzanine",
        "360 Deg   (Sta Chn:  9)     Location: Mezzanine",
        "360 Deg   (Sta Chn: 10)     Location: Ground floor"};
    for (std::size_t i = 0; i < channels.size(); ++i)
      write(fmt::format("CHAN{:02}.V2", i + 1),
            csmip_v2(fmt::format("Chan {:2}: {}", i + 1, channels[i]), static_cast<double>(i)));
    write("CHAN01.V3", "Response and Fourier amplitude spectra (83 periods)   for\nChan  1: Up\n");
  }
  SuiteImport import_roof(const std::string& roof) const {
    ImportOptions options;
    options.roof = roof;
    return import(options);
  }
};

TEST_F(StructureImporter, the_free_field_is_a_record_and_every_other_file_has_its_reason) {
  const SuiteImport found = import();
  ASSERT_EQ(found.records.size(), 1u) << reasons(found);
  EXPECT_EQ(files_of(found, found.records[0]), "CHAN03.V2, CHAN02.V2, CHAN01.V2");
  EXPECT_EQ(found.left_out.size(), 8u);
  EXPECT_THAT(reasons(found),
              test::states("CHAN01.V3: ", "CHAN04.V2: channel 4 at 'Roof: center' of a structure",
                           "CHAN10.V2: channel 10 at 'Ground floor' of a structure", "--roof"));
}

/// Of CSMIP, CESMD and COSMOS; also in lower case. A ground level beside a structure is warned of.
TEST_F(SuiteImporter, names_of_the_free_field_are_ground_motion) {
  const auto channels_at = [&](const std::string& location) {
    write("C1.V2", csmip_v2("Chan 1: 90 Deg (Sta Chn: 1) Location: " + location, 1));
    write("C2.V2", csmip_v2("Chan 2: 360 Deg (Sta Chn: 2) Location: " + location, 2));
    return import();
  };
  for (const char* location : {"Ground Level", "FF", "Surface", "Free Field", "Freefield",
                               "FREE-FIELD: 30 m W", "ground surface", "ff", "ground"})
    EXPECT_EQ(channels_at(location).records.size(), 1u) << location;
  for (const char* location : {"Ground floor", "Ground Level: N wall", "Roof surface", "1st FF"})
    EXPECT_THAT(channels_at(location).records, IsEmpty()) << location;
  write("C3.V2", csmip_v2("Chan 3: 360 Deg (Sta Chn: 3) Location: Roof", 3));
  EXPECT_THAT(channels_at("Free field").records.at(0).warnings, IsEmpty());
  EXPECT_THAT(channels_at("Ground level").records.at(0).warnings,
              ElementsAre(HasSubstr("may be the base of the structure")));
}

TEST_F(StructureImporter, a_location_is_a_motion_of_a_roof) {
  const SuiteImport found = import_roof("MEZZanine");
  ASSERT_EQ(found.records.size(), 1u) << reasons(found);
  EXPECT_EQ(files_of(found, found.records[0]), "CHAN09.V2, CHAN08.V2, -");
  EXPECT_EQ(found.left_out.size(), 9u);
  EXPECT_THAT(reasons(found), HasSubstr("CHAN02.V2: channel 2 at 'Free field' is not of --roof"));
  ImportedSuiteHead head{"s", {}, {}, true};
  const Suite suite =
      load_suite(folder_.write("suite.toml", imported_suite_toml(found, head, folder_.path())));
  EXPECT_TRUE(suite.of_roof);
  EXPECT_THAT(found.records[0].warnings, IsEmpty());
  EXPECT_THAT(import_roof("free field").records.at(0).warnings,
              ElementsAre(test::states("'Free field'", "no roof")));
  EXPECT_EQ(suite.motions.at(0).horizontal_mps2[1].size(), 200u);
}

TEST_F(StructureImporter,
       channels_of_several_locations_are_one_motion_where_their_numbers_are_given) {
  EXPECT_THAT(import_roof("roof").records, IsEmpty());  // N and S walls are parallel
  EXPECT_THAT(reasons(import_roof("roof")), HasSubstr("CHAN05.V2: one horizontal component only"));
  const SuiteImport found = import_roof("4, 6 7");
  ASSERT_EQ(found.records.size(), 1u) << reasons(found);
  EXPECT_EQ(files_of(found, found.records[0]), "CHAN06.V2, CHAN04.V2, CHAN07.V2");
  EXPECT_THAT(found.records[0].warnings,
              ElementsAre(test::states("several locations", "Roof: S wall", "Roof: center")));
  EXPECT_THAT(reasons(import_roof("4,5,6")), HasSubstr("one of 3 horizontal and 0 vertical"));
}

TEST_F(StructureImporter, a_roof_that_is_not_among_the_channels_is_refused_with_their_list) {
  EXPECT_THAT(message_of([&] { import_roof("penthouse"); }),
              test::states("--roof", "penthouse", "channel 4, 90: Roof: center"));
  EXPECT_THAT(message_of([&] { import_roof("4,5,11"); }), test::states("channel 11", "channel 10"));
  EXPECT_THAT(message_of([&] { import_roof(" "); }), HasSubstr("names no channel"));
}

}  // namespace
}  // namespace glissade
