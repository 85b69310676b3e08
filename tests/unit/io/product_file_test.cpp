// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/io/product_file.hpp"

#include <gmock/gmock.h>

#include "glissade/io/study_file.hpp"
#include "problems.hpp"
#include "temporary_folder.hpp"

// The studies of a product are of the values of its file, however they are written.
namespace glissade {
namespace {

namespace fs = std::filesystem;

const std::string rest = R"([building]
period_s = [0.3, 0.35]
[roof]
slope_deg = [0, 2, 9]
[friction]
mu = [0.15, 0.3]
)";

class ProductFile : public testing::Test {
 protected:
  ProductFile() {
    fs::create_directories(folder_.path() / "own");
    for (const char* name : {"a.toml", "b.toml"})
      folder_.write(std::string("own/") + name, "[suite]\nname = \"a\"\n[[record]]\nid = \"a\"\n");
  }
  /// Written beside the folder of the product, and read from there.
  StudyConfig study_of(const std::string& text) {
    const Product product = read_product(folder_.write("own/product.toml", text));
    return read_study(folder_.write("target_1.toml", product_study(product, 0, folder_.path())));
  }
  TemporaryFolder folder_;
};

TEST_F(ProductFile, of_tables_of_any_form_gives_the_same_study) {
  const std::string tables =
      "[product]\nname = \"racking\"\nunit = \"ft\"\n[[target]]\nsds_g = 1.2\nsd1_g = 0.5\n"
      "[suite]\nfile = \"a.toml\"\n[hazard]\nk = 2.5\ndesign_life_years = 25\n" +
      rest;
  const StudyConfig study = study_of(tables);
  EXPECT_EQ(study.name, "racking");
  EXPECT_EQ(study.intensity.target.value().sds_g, 1.2);
  const std::string
      in_lines =
          "product = { name = \"racking\", unit = \"ft\" }\n"
          "suite.file = 'a.toml'\n"
          "hazard = { k = 2.5, design_life_years = 25 }\n"
          "target = [{ sds_g = 1.2, sd1_g = 0.5 }]\n" +
          rest,
      over_lines =
          "product.name = \"racking\"\nproduct.unit = \"ft\"\nhazard.k = 2.5\n"
          "hazard.design_life_years = 25\n[[ target ]] # \"[x]\"\nsds_g = 1.2\nsd1_g = 0.5\n"
          "[suite]\nfile = \"\"\"a.toml\"\"\"\n[building]\nperiod_s = [\n  0.3,   \n  0.35\n] \n"
          "[roof]\nslope_deg = [ 0,\n 2, 9 ]\t\n[friction]\nmu = [\n0.15, 0.3]\n";
  for (const std::string& other : {in_lines, over_lines})
    EXPECT_EQ(study_of(other).source_text, study.source_text);
}

TEST_F(ProductFile, has_paths_from_its_own_folder) {
  const std::string head = "[product]\nname = \"racking\"\n[[target]]\nsds_g = 1.2\nsd1_g = 0.5\n";
  const fs::path own = folder_.path() / "own";
  EXPECT_THAT(study_of(head + "[suite]\nfiles = [\"a.toml\", \"b.toml\"]\n" + rest).suite_files,
              testing::ElementsAre(own / "a.toml", own / "b.toml"));
  EXPECT_THAT(
      study_of(head + "[suite]\nfile = \"" + (own / "b.toml").string() + "\"\n" + rest).suite_files,
      testing::ElementsAre(own / "b.toml"));
}

TEST_F(ProductFile, that_is_wrong_names_the_line_of_the_user) {
  const std::string text =
      "[product]\nname = \"racking\"\n[[target]]\nsds_g = 1.2\nsd1_g = 0.5\n"
      "[suite]\nfile = \"a.toml\"\nrecords = [\"\\u001b[2J\"]\n" +
      rest;
  EXPECT_THAT(problems_of([&] { study_of(text); }),
              one_problem("product.toml:8", "suite.records", "control character"));
}

TEST_F(ProductFile, is_shown_without_its_comments) {
  const std::string text =
      "# a product\n[product]   # \"of\nname = \"A # 1\"  # it's\nmanufacturer = '''x\n\n# y'''\n\n"
      "[[target]]\nsds_g = 1.2\nsd1_g = 0.5\n[suite]\nfile = 'a.toml' # '\n" +
      rest;
  EXPECT_EQ(read_product(folder_.write("own/product.toml", text)).source_text,
            "[product]\nname = \"A # 1\"\nmanufacturer = '''x\n\n# y'''\n\n[[target]]\n"
            "sds_g = 1.2\nsd1_g = 0.5\n\n[suite]\nfile = 'a.toml'\n\n[building]\n"
            "period_s = [0.3, 0.35]\n\n[roof]\nslope_deg = [0, 2, 9]\n\n[friction]\n"
            "mu = [0.15, 0.3]\n");
}

}  // namespace
}  // namespace glissade
