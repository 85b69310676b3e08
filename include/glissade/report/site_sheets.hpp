// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "glissade/core/units.hpp"
#include "glissade/report/html_text.hpp"
#include "glissade/report/package.hpp"

// The sheets of a project of several sites or roofs: a page for each and a summary.
namespace glissade {

/// What the summary has of the package of a site.
struct SiteSheet {
  std::string name, folder;  ///< folder: of its package, below that of the summary
  double sds_g = 0.0, sd1_g = 0.0;
  std::optional<double> s1_g;  ///< where it is stated
  double friction = 0.0;       ///< mean - 2 std
  double governing_m = 0.0, largest_required_m = 0.0;
  bool is_simulated = false;  ///< its motions
  std::string verdict;  ///< "sufficient", "not sufficient", "open", "not applicable", "not stated"
  Html page;
  std::vector<std::string> user_texts;  ///< names and ids on it
};
SiteSheet site_sheet(const CalculationPackage& package, const std::string& folder);

struct SiteSheets {
  std::string name;  ///< of the project, without that of a site
  UnitSystem units = UnitSystem::us_customary;
  std::vector<SiteSheet> sites;
};

/// The summary, in plain ASCII.
std::string sites_screen(const SiteSheets& sheets);

/// Writes out_dir/sites.html and sites.xlsx, with tables/sites.csv, and prints the page to
/// sites.pdf: false where WeasyPrint is not installed.
bool write_site_sheets(const SiteSheets& sheets, const std::filesystem::path& out_dir);

}  // namespace glissade
