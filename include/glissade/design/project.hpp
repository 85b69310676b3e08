// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "glissade/core/units.hpp"
#include "glissade/fragility/hazard.hpp"
#include "glissade/motion/design_spectrum.hpp"
#include "glissade/sampling/friction_statistics.hpp"
#include "glissade/standards/code_values.hpp"
#include "glissade/study/config.hpp"

// A project: one array on the roof of one building, as an engineer describes it for a permit.
namespace glissade {

struct TitleBlock {
  /// Empty: left to be filled in.
  std::string name, address, authority, code, engineer, licence, revision, date;
};

/// What numbers come from; empty: not stated.
struct StatedReport {
  std::string report, author, date;
};

struct ProjectSite {
  DesignTarget target;
  std::optional<DesignTarget> mapped;  ///< S_S, S_1 and site class beside a spectrum by points
  bool states_tl = true;               ///< or T_L is as usual
  RiskCategory risk = RiskCategory::ii;
  std::optional<double> fault_distance_km;  ///< to the nearest active fault
  StatedReport analysis;                    ///< that gave the spectrum, or S_DS and S_D1

  /// The spectrum is not that of the maps, nor of exception 2 of 11.4.8.
  bool is_of_analysis() const;
};

struct ProjectBuilding {
  std::vector<double> period_s;                ///< increasing, > 0; of a roof's motions {0}
  std::string period_basis;                    ///< "as given", or the equation with its numbers
  std::string bounds_text;                     ///< "0.75 to 1.5 times T_a"
  std::string system;                          ///< as in table 12.8-2; empty: not stated
  bool system_is_checked = false;              ///< its row of the table is
  std::optional<double> height_m;              ///< where the period comes from it
  std::optional<double> approximate_period_s;  ///< T_a of that height
  std::optional<double> storeys;               ///< above ground, where given
  /// Of a uniform cantilever of flexure and shear, increasing; empty: one mass.
  std::vector<double> alpha;
  std::string model_basis = "one storey, or storeys not stated";
  std::vector<double> mass_ratio;           ///< of the array to the building, increasing
  std::string mass_basis = "project file";  ///< or the weights that it is the ratio of
  double damping = 0.05;
  std::string diaphragm;  ///< of the roof: "rigid", "semirigid", "flexible"; empty: not stated
};

/// What conditions of the standards ask; none: not stated.
struct ProjectArray {
  std::string model, ballast, membrane;  ///< empty: not stated
  std::optional<double> centre_of_mass_m, support_spacing_m, interconnection;  ///< as ArrayFacts
};

struct ProjectFriction {
  double mean = 0.5, std = 0.0;
  std::optional<double> lower_bound;  ///< 95 % confidence bound of MuStatistics, the lowest of all
                                      ///< directions; none: the number of tests is not known
  std::optional<std::size_t> tests;   ///< behind mean and std; none: not stated
  std::string source;                 ///< "7 pull tests in pulls.csv (SHA-256 ...)"
  std::vector<DirectionFriction> tested;  ///< of pull tests, each direction; empty: mean, std given
  std::string direction;                  ///< the one of them that is taken
  std::string bound_direction;            ///< the one of the lower bound
  std::vector<TraceFriction> traces;      ///< of logged pull tests
  /// Of the test report; empty: not stated.
  std::string report, laboratory, tested_on, test_standard;
  std::string surface;  ///< "dry", "wet" or "both"
  std::string surface_description;

  /// "wet: TPO, feet of EPDM"
  std::string surface_text() const;
  /// mean - 2 std (Walters et al. 2012), not below 0.
  double design() const;
};

/// What an array may come near to, with what the project's standard requires; `available_m` where
/// the project states it.
struct ProjectSeparation {
  Separation required;
  std::optional<double> available_m;
  std::size_t kind = 0;   ///< of separations_of()
  std::string name = {};  ///< of a gap; else empty

  /// "to a fixed object or a different array: skylight 3"
  std::string text() const { return name.empty() ? required.what : required.what + ": " + name; }
};

/// A named distance on the roof.
struct ProjectGap {
  std::string name;
  std::size_t kind = 0;  ///< of separations_of()
  double available_m = 0.0;
};

/// How often the site has shaking of each S_DS. Of `curve`, a file relative to the project's, or
/// k0 x^-k.
struct ProjectHazard {
  std::string curve, sha256;
  std::vector<HazardPoint> points;
  double k0 = 0.0, k = 0.0;
  double design_life_years = 0.0;
};

struct Project {
  std::filesystem::path file;
  std::string source_text;  ///< of the file, without its comments
  std::string read_on;      ///< the day, UTC: "2026-10-14"
  TitleBlock title;
  UnitSystem units = UnitSystem::us_customary;
  ProjectSite site;
  std::string site_name;  ///< of one of several sites or roofs; else empty
  ProjectBuilding building;
  std::vector<double> slope_deg;  ///< increasing, >= 0
  ProjectFriction friction;
  ProjectArray array;
  std::string spectrum_file;  ///< of a target by points, relative to the project file
  std::string spectrum_sha256;
  std::filesystem::path suite;  ///< suite file
  /// The motions of the suite are those of the roof: no building is computed, and its period and
  /// mass ratio are 0.
  bool of_roof = false;
  bool simulated_motions = false;  ///< the suite has no records
  double roof_factor = 1.0;        ///< on the motions of a roof, at the design earthquake
  StatedReport roof;               ///< on its motions
  ScalingRule scaling_rule = ScalingRule::walters_2012;
  bool without_target = false;  ///< also one that falls short at periods above 2 s
  std::uint64_t samples = 128, seed = 1;
  std::optional<ProjectHazard> hazard;
  std::vector<std::optional<double>> available_m;  ///< by separation of separations_of()
  std::vector<ProjectGap> gaps;                    ///< beside these
  Standard standard = Standard::asce7_16;
  double importance = 1.0;
  bool peer_reviewed = false;
  double round_up_m = 0.0127;
  /// Of a project in US units: "height_m = 54 (177 ft)", without a unit in the file.
  std::vector<std::string> unmarked_numbers;
};

}  // namespace glissade
