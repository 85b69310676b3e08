// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/report/conditional_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace glissade {
namespace {

std::string plain(double value) { return fmt::format("{:g}", value); }

/// exp(mean + deviations x sigma) by period.
DataSeries quantile_line(const SpectrumDistribution& of, double deviations, const Look& look,
                         const std::string& name, const std::string& label) {
  DataSeries line{DataSeries::Kind::line, look, name, label};
  for (std::size_t p = 0; p < of.size(); ++p) line.add(of.periods_s[p], of.sa_g(p, deviations));
  return line;
}

}  // namespace

Figure conditional_figure(const ConditionalTarget& target, const ConditionalSelection& selection,
                          const std::string& target_text) {
  constexpr double in_95_percent = 1.959963984540054;
  const SpectrumDistribution& spectrum = target.spectrum;
  Figure figure{
      "conditional_spectrum", "Response spectra of the selected records and their target",
      fmt::format("conditional on Sa({:g} s) = {:g} g; {} records of {} candidates",
                  target.period_s(), target.sa_g, selection.records.size(), selection.candidates),
      "RotD50 spectra at 5 % damping of the records, each scaled to the known spectral "
      "acceleration (grey); their mean of ln Sa, and mean and 95 % range of the target: " +
          target_text + "."};
  DataSeries records{DataSeries::Kind::line, look(Role::record), "records", "each record"};
  double lowest = spectrum.sa_g(0, -in_95_percent), highest = lowest;
  const auto widen = [&](double sa_g) {
    lowest = std::min(lowest, sa_g);
    highest = std::max(highest, sa_g);
  };
  for (const std::vector<double>& sa_g : selection.spectra_g) {
    for (std::size_t p = 0; p < sa_g.size(); ++p) {
      records.add(spectrum.periods_s[p], sa_g[p]);
      widen(sa_g[p]);
    }
    records.end_line();
  }
  for (std::size_t p = 0; p < spectrum.size(); ++p)
    for (const double deviations : {-in_95_percent, in_95_percent})
      widen(spectrum.sa_g(p, deviations));
  DataSeries mean{DataSeries::Kind::line, look(Role::mean), "mean", "mean of the records"};
  for (std::size_t p = 0; p < spectrum.size(); ++p)
    mean.add(spectrum.periods_s[p], std::exp(selection.mean[p]));
  Look middle = look(Role::target), ends = middle;
  middle.dash = 1;
  ends.width = 2.0;
  figure.panels = {
      {"",
       {"Period (s)", 0.0, spectrum.periods_s.back()},
       log_axis("Spectral acceleration, RotD50 (g)", lowest / 1.1, 1.1 * highest, plain,
                {1.0, 2.0, 5.0}),
       {records, quantile_line(spectrum, 0.0, middle, "target", "target, mean"),
        quantile_line(spectrum, -in_95_percent, ends, "target 2.5 %", "target, 2.5 and 97.5 %"),
        quantile_line(spectrum, in_95_percent, ends, "target 97.5 %", ""), mean}}};
  return figure;
}

}  // namespace glissade
