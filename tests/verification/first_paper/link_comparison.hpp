// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "elastic_link/elastic_link.hpp"
#include "glissade/motion/motion.hpp"
#include "verification/case.hpp"

namespace glissade::verification {

/// One of the paper's 16 cases: flat with ten frictions, 4 deg with six.
struct LinkScene {
  double friction, slope_deg;
  Block block() const { return {friction, slope_deg * rad_per_deg}; }
};

/// What is compared with slide(): elastic links and the published scheme.
struct LinkModel {
  std::string name;
  std::function<test::LinkSlip(const RoofAcceleration&, const Block&)> solve;
  std::optional<test::ElasticLink> link;  ///< none: the published scheme
};

/// Their places in link_models().
enum Model : std::size_t {
  paper_link,  ///< 100 N/mm, 1 ms
  fine_step,   ///< 100 N/mm, 0.25 ms
  soft,        ///< 10 N/mm, 1 ms
  unstable,    ///< 1000 N/mm, 1 ms
  stiff,       ///< 1000 N/mm, 0.25 ms
  stiffest,    ///< 10,000 N/mm, 0.05 ms
  rounded,     ///< 100 N/mm, 1 ms, Wen's knee
  scheme_64,   ///< published scheme, P = 64
  scheme_32,   ///< P = 32: on motions of twice the paper's rate, its substep
};
const std::vector<LinkModel>& link_models();

/// A scene under one motion at PPA 1.0 g, by all of them.
struct LinkRun {
  std::size_t motion;
  LinkScene scene;
  SlipResult exact;
  std::vector<test::LinkSlip> by_model;
};
std::vector<LinkRun> run_links(const Suite& suite);

enum class Roof { flat, sloping };

inline constexpr std::size_t every_motion = static_cast<std::size_t>(-1);

/// Which runs a statistic is over.
struct Selection {
  Roof roof;
  std::size_t motions = every_motion;  ///< the first so many
};

struct Spread {
  double mean = 0.0, largest = 0.0;
};
/// Of a number over the runs selected.
Spread spread(const std::vector<LinkRun>& runs, const Selection& selected,
              const std::function<double(const LinkRun&)>& value);

/// |RRD| by the model less |RRD| exact, without sign, as the paper takes residuals.
double residual_error_m(const LinkRun& run, Model model);

/// In Markdown.
std::string link_tables(const std::vector<LinkRun>& runs);
/// PRD and RRD under the first motion.
CsvFile link_scenes(const std::vector<LinkRun>& runs);
std::vector<Finding> link_findings(const std::vector<LinkRun>& runs);
/// PRD and RRD over friction under the first motion; two files.
void draw_links(const std::vector<LinkRun>& runs, const Motion& first,
                const std::filesystem::path& figures);

}  // namespace glissade::verification
