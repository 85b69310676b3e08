// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "glissade/motion/simulation/bssa14.hpp"
#include "glissade/motion/simulation/gulerce_abrahamson.hpp"

namespace glissade {
namespace {

struct Vector {
  Scenario scenario;
  double period_s, expected;
};

// OpenQuake's BSSA_2014_MEAN.csv (strike-slip), g.
constexpr Vector openquake[] = {
    {{6.0, 20.0, 400.0}, 0, 0.135537},    {{6.0, 20.0, 400.0}, 0.1, 0.255775},
    {{6.0, 20.0, 400.0}, 0.2, 0.357161},  {{6.0, 20.0, 400.0}, 0.5, 0.186971},
    {{6.0, 20.0, 400.0}, 1.0, 0.0871926}, {{6.0, 20.0, 400.0}, 2.0, 0.0286858},
    {{6.0, 20.0, 760.0}, 0, 0.0990773},   {{6.0, 20.0, 760.0}, 0.1, 0.210697},
    {{6.0, 20.0, 760.0}, 0.2, 0.258547},  {{6.0, 20.0, 760.0}, 0.5, 0.109086},
    {{6.0, 20.0, 760.0}, 1.0, 0.046683},  {{6.0, 20.0, 760.0}, 2.0, 0.0149733},
    {{7.0, 20.0, 400.0}, 0, 0.200024},    {{7.0, 20.0, 400.0}, 0.1, 0.338914},
    {{7.0, 20.0, 400.0}, 0.2, 0.454207},  {{7.0, 20.0, 400.0}, 0.5, 0.332947},
    {{7.0, 20.0, 400.0}, 1.0, 0.183794},  {{7.0, 20.0, 400.0}, 2.0, 0.0806607},
    {{7.0, 20.0, 760.0}, 0, 0.149712},    {{7.0, 20.0, 760.0}, 0.1, 0.290322},
    {{7.0, 20.0, 760.0}, 0.2, 0.341846},  {{7.0, 20.0, 760.0}, 0.5, 0.199656},
    {{7.0, 20.0, 760.0}, 1.0, 0.10001},   {{7.0, 20.0, 760.0}, 2.0, 0.0423375},
    {{7.0, 0.0, 400.0}, 0, 0.564823},     {{7.0, 0.0, 400.0}, 0.1, 0.960719},
    {{7.0, 0.0, 400.0}, 0.2, 1.26877},    {{7.0, 0.0, 400.0}, 0.5, 0.997607},
    {{7.0, 0.0, 400.0}, 1.0, 0.590399},   {{7.0, 0.0, 400.0}, 2.0, 0.247109},
    {{7.0, 50.0, 400.0}, 0, 0.0913472},   {{7.0, 50.0, 400.0}, 0.1, 0.151785},
    {{7.0, 50.0, 400.0}, 0.2, 0.207516},  {{7.0, 50.0, 400.0}, 0.5, 0.150217},
    {{7.0, 50.0, 400.0}, 1.0, 0.0798422}, {{7.0, 50.0, 400.0}, 2.0, 0.0347511},
    {{7.0, 20.0, 200.0}, 0, 0.220664},    {{7.0, 20.0, 200.0}, 0.1, 0.326079},
    {{7.0, 20.0, 200.0}, 0.2, 0.477707},  {{7.0, 20.0, 200.0}, 0.5, 0.433609},
    {{7.0, 20.0, 200.0}, 1.0, 0.281115},  {{7.0, 20.0, 200.0}, 2.0, 0.158651},
};

// pygmm's GA11 (strike-slip) with BSSA14's rock PGA, four digits, same file.
constexpr Vector vertical_over_horizontal[] = {
    {{6.0, 5.0, 400.0}, 0, 0.7919},     {{6.0, 5.0, 400.0}, 0.05, 1.2513},
    {{6.0, 5.0, 400.0}, 0.1, 0.9396},   {{6.0, 5.0, 400.0}, 0.2, 0.5719},
    {{6.0, 5.0, 400.0}, 0.5, 0.3910},   {{6.0, 5.0, 400.0}, 1.0, 0.4042},
    {{6.0, 5.0, 400.0}, 2.0, 0.4458},   {{7.0, 20.0, 400.0}, 0, 0.6859},
    {{7.0, 20.0, 400.0}, 0.05, 0.9751}, {{7.0, 20.0, 400.0}, 0.1, 0.8007},
    {{7.0, 20.0, 400.0}, 0.2, 0.5508},  {{7.0, 20.0, 400.0}, 0.5, 0.3899},
    {{7.0, 20.0, 400.0}, 1.0, 0.4161},  {{7.0, 20.0, 400.0}, 2.0, 0.4589},
    {{7.5, 10.0, 760.0}, 0, 0.7571},    {{7.5, 10.0, 760.0}, 0.05, 1.0433},
    {{7.5, 10.0, 760.0}, 0.1, 0.8253},  {{7.5, 10.0, 760.0}, 0.2, 0.5540},
    {{7.5, 10.0, 760.0}, 0.5, 0.4898},  {{7.5, 10.0, 760.0}, 1.0, 0.5794},
    {{7.5, 10.0, 760.0}, 2.0, 0.6008},
};

TEST(bssa14, reproduces_the_table_of_OpenQuake) {
  for (const auto& [scenario, period_s, expected] : openquake)
    EXPECT_NEAR(bssa14_median_sa_g(scenario, period_s) / expected, 1.0, 1e-4)
        << "M" << scenario.magnitude << " R" << scenario.distance_km << " V" << scenario.vs30_mps
        << " T" << period_s;
}

TEST(bssa14, reproduces_the_peak_velocities_of_OpenQuake) {
  EXPECT_NEAR(bssa14_median_pgv_mps({6.0, 20.0, 400.0}), 0.0895944, 1e-4 * 0.0896);
  EXPECT_NEAR(bssa14_median_pgv_mps({6.0, 20.0, 760.0}), 0.0547571, 1e-4 * 0.0548);
  EXPECT_NEAR(bssa14_median_pgv_mps({7.0, 20.0, 400.0}), 0.206835, 1e-4 * 0.207);
  EXPECT_NEAR(bssa14_median_pgv_mps({7.0, 20.0, 760.0}), 0.128371, 1e-4 * 0.128);
  EXPECT_NEAR(bssa14_median_pgv_mps({7.0, 0.0, 400.0}), 0.675831, 1e-4 * 0.676);
  EXPECT_NEAR(bssa14_median_pgv_mps({7.0, 50.0, 400.0}), 0.0886678, 1e-4 * 0.0887);
  EXPECT_NEAR(bssa14_median_pgv_mps({7.0, 20.0, 200.0}), 0.277635, 1e-4 * 0.278);
}

// Boore et al. (2014): sqrt(tau2^2 + phi2^2) for M >= 5.5, Vs30 >= 300, R <= 79.
TEST(bssa14, has_the_published_dispersion) {
  const Scenario scenario{7.0, 20.0, 400.0};
  EXPECT_NEAR(bssa14_dispersion(scenario, 0.0).total(), std::hypot(0.348, 0.495), 1e-12);
  EXPECT_NEAR(bssa14_dispersion(scenario, 0.1).total(), std::hypot(0.458, 0.541), 1e-12);
  EXPECT_NEAR(bssa14_dispersion(scenario, 1.0).between_events, 0.298, 1e-12);
}

// Coefficients of PGA: phi1 .695, phi2 .495, tau1 .398, tau2 .348, dphi_R .1 from 110 to 270 km,
// dphi_V .07.
TEST(bssa14, changes_its_dispersion_with_magnitude_distance_and_soil) {
  EXPECT_NEAR(bssa14_dispersion({4.0, 20.0, 400.0}, 0.0).within_event, 0.695, 1e-12);
  EXPECT_NEAR(bssa14_dispersion({5.0, 20.0, 400.0}, 0.0).between_events, 0.5 * (0.398 + 0.348),
              1e-12);
  EXPECT_NEAR(bssa14_dispersion({7.0, 300.0, 400.0}, 0.0).within_event, 0.595, 1e-12);
  EXPECT_NEAR(bssa14_dispersion({7.0, 20.0, 225.0}, 0.0).within_event, 0.425, 1e-12);
  EXPECT_NEAR(bssa14_dispersion({7.0, 20.0, std::sqrt(225.0 * 300.0)}, 0.0).within_event, 0.46,
              1e-12);
}

// Coefficients of PGA: e1 .4856 (strike-slip) and e3 .4539 (reverse); on rock nothing else depends
// on the mechanism.
TEST(bssa14, tells_reverse_motions_on_rock_by_their_constants) {
  const double ratio = bssa14_median_sa_g({7.0, 20.0, 760.0, FaultMechanism::reverse}, 0.0) /
                       bssa14_median_sa_g({7.0, 20.0, 760.0}, 0.0);
  EXPECT_NEAR(ratio, std::exp(0.4539 - 0.4856), 1e-12);
}

TEST(bssa14, lies_between_its_tabulated_periods) {
  const Scenario scenario{7.0, 20.0, 400.0};
  const double at = bssa14_median_sa_g(scenario, 1.1), below = bssa14_median_sa_g(scenario, 1.0),
               above = bssa14_median_sa_g(scenario, 1.2);
  EXPECT_LT(at, below);
  EXPECT_GT(at, above);
}

TEST(gulerce_abrahamson, reproduces_the_ratios_of_pygmm) {
  for (const auto& [scenario, period_s, expected] : vertical_over_horizontal)
    EXPECT_NEAR(vertical_to_horizontal_ratio(scenario, period_s), expected, 1.1e-4)
        << "M" << scenario.magnitude << " R" << scenario.distance_km << " V" << scenario.vs30_mps
        << " T" << period_s;
}

TEST(outside_bssa14, names_what_is_outside_the_ranges_of_the_authors) {
  EXPECT_TRUE(outside_bssa14({3.0, 0.0, 150.0}).empty());
  EXPECT_TRUE(outside_bssa14({8.5, 400.0, 1500.0}).empty());
  EXPECT_EQ(outside_bssa14({8.6, 401.0, 149.0}).size(), 3u);
  EXPECT_NE(outside_bssa14({7.0, 20.0, 1600.0}).at(0).find("V_S30 of 1600 m/s"), std::string::npos);
}

}  // namespace
}  // namespace glissade
