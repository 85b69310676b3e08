// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "convergence/text.hpp"
#include "figure_text.hpp"
#include "glissade/report/convergence_report.hpp"
#include "gnuplot.hpp"

namespace glissade {
namespace {

/// A logarithmic range of whole decades.
struct Decades {
  double low = 0.0, high = 0.0;
  void take(double value) {
    if (!(value > 0.0) || !std::isfinite(value)) return;
    const double below = std::pow(10.0, std::floor(std::log10(value)));
    low = high == 0.0 ? below : std::min(low, below);
    high = std::max(high, 10.0 * below);
  }
};

/// A log-log plot has no place for zero.
double above_zero(double value) { return value > 0.0 ? value : std::nan(""); }

void add_errors(const ConvergenceResults& results, gnuplot::DataBlocks& data, Decades& range) {
  data.begin("error",
             "substeps largest_of_finest_percent largest_of_exact_residual_percent "
             "largest_of_exact_peak_percent largest_of_finest_clear_percent");
  for (std::size_t step = 0; step < results.substeps.size(); ++step) {
    const auto summary = [&](ErrorMeasure measure) {
      return error_summary(results, step, measure);
    };
    std::vector<double> row{static_cast<double>(results.substeps[step])};
    for (const double share :
         {summary(ErrorMeasure::finest).largest, summary(ErrorMeasure::exact_residual).largest,
          summary(ErrorMeasure::exact_peak).largest, clear_error(results, step).largest}) {
      row.push_back(above_zero(100.0 * share));
      range.take(row.back());
    }
    data.row(row);
  }
}

void add_times(const ConvergenceResults& results, const ConvergenceTimes& times,
               gnuplot::DataBlocks& data, Decades& range) {
  data.begin("time", "substeps published_longest_s exact_longest_s kernel_longest_s");
  for (std::size_t step = 0; step < results.substeps.size(); ++step) {
    const std::vector<double> row{
        static_cast<double>(results.substeps[step]), above_zero(times.published[step].longest_s),
        above_zero(times.exact.longest_s), above_zero(times.kernel.longest_s)};
    std::for_each(row.begin() + 1, row.end(), [&](double s) { range.take(s); });
    data.row(row);
  }
}

std::string log_axis(const std::string& which, const Decades& range, const char* format) {
  return fmt::format("set logscale {0}\nset {0}range [{1}:{2}]\nset format {0} '{3}'\n", which,
                     range.low, range.high, format);
}

std::string error_lines(const std::string& file, int finest) {
  return fmt::format(
      "plot \\\n"
      "  {0} index 'error' using 1:3 with linespoints lw 2 dt 2 pt 6 ps 1.4 lc rgb '#d55e00' title "
      "'largest error relative to the exact residual', \\\n"
      "  {0} index 'error' using 1:2 with linespoints lw 2.5 pt 7 ps 0.9 lc rgb '#0072b2' title "
      "'largest error relative to the residual at P = {1}{5}', \\\n"
      "  {0} index 'error' using 1:5 with linespoints lw 2 dt 4 pt 5 ps 0.9 lc rgb '#56b4e9' title "
      "'the same without residuals below {2} of the peak', \\\n"
      "  {0} index 'error' using 1:4 with linespoints lw 2 pt 9 ps 1 lc rgb '#009e73' title "
      "'largest error relative to the exact peak displacement', \\\n"
      "  {0} index 'paper' using 1:2 with points pt 3 ps 2 lw 2 lc rgb '#0072b2' title 'the paper, "
      "on its own record: {3} at P = {4}'",
      file, finest, stated_percent(clear_residual), stated_percent(published::largest_error),
      published::substeps, finest == published::finest ? ", as the paper has it" : "");
}

std::string time_lines(const std::string& file) {
  return fmt::format(
      ", \\\n  {0} index 'time' using 1:2 axes x1y2 with linespoints lw 2 pt 5 ps 0.8 lc rgb "
      "'#777777' title 'longest time of a history of the scheme (right axis)', \\\n"
      "  {0} index 'time' using 1:3 axes x1y2 with lines lw 2 dt 4 lc rgb '#000000' title "
      "'longest time of the exact solution, event by event (right axis)', \\\n"
      "  {0} index 'time' using 1:4 axes x1y2 with lines lw 2 dt 3 lc rgb '#000000' title "
      "'longest time of the exact solution, over tables (right axis)', \\\n"
      "  {0} index 'paper' using 1:3 axes x1y2 with points pt 3 ps 2 lw 2 lc rgb '#777777' title "
      "'the paper, on its computer: less than {1} s at P = {2}'",
      file, published::longest_s, published::substeps);
}

bool shows_the_paper(const ConvergenceResults& results) {
  return results.substeps.front() <= published::substeps &&
         published::substeps <= results.substeps.back();
}

}  // namespace

Figure convergence_figure(const ConvergenceResults& results, const MaybeTimes& times) {
  const int finest = results.substeps.back();
  Figure figure;
  figure.name = "convergence";
  figure.title = "The published scheme: largest error and longest time";
  figure.caption = fmt::format(
      "After Rodriguez-Nikl et al. (2019), Fig. 5: largest error of the residual displacement over "
      "{} scenes on {} records when a sample interval is cut into P substeps. The paper takes P = "
      "{} as the truth; here the exact solution is known, so the error is shown against it too. "
      "Where the block happens to come back near to where it began, an error relative to the "
      "residual is large though the block is hardly off in metres: relative to the peak "
      "displacement "
      "it is not. Stars: what the paper states of its own record at P = {}.",
      results.scenes.size(), results.records.size(), finest, published::substeps);
  gnuplot::DataBlocks data;
  data.begin("paper", "substeps largest_error_percent longest_time_s");
  data.row({1.0 * published::substeps, 100.0 * published::largest_error, published::longest_s});
  Decades errors, seconds;
  errors.take(100.0 * published::largest_error);
  seconds.take(5.0 * published::longest_s);  // room for the label above
  add_errors(results, data, errors);

  const std::string file = quoted_file(figure.name);
  std::string plot = error_lines(file, finest);
  std::string axes = axis("x", "P, substeps of a sample interval") +
                     axis("y", "Largest error (%)") + log_axis("y", errors, "%g");
  figure.key_rows = 5;
  if (shows_the_paper(results)) {
    axes += fmt::format(
        "set label 'paper: {}' at first {}, first {} left offset 1.6,0 front boxed tc rgb "
        "'#0072b2'\n",
        stated_percent(published::largest_error), published::substeps,
        100.0 * published::largest_error);
  }
  if (times) {
    add_times(results, *times, data, seconds);
    plot += time_lines(file);
    figure.key_rows += 4;
    axes += axis("y2", "Longest time of a history (s)") + log_axis("y2", seconds, "10^{%T}") +
            "set y2tics out nomirror\nset border 11\n";
    if (shows_the_paper(results)) {
      axes += fmt::format(
          "set label 'paper: below {0} s' at first {1}, second {0} center offset 0,1.1 tc rgb "
          "'#777777'\n",
          published::longest_s, published::substeps);
    }
  }
  const double left = results.substeps.front(), right = finest;
  figure.body = title_of(figure, fmt::format("{} scenes x {} records, {}", results.scenes.size(),
                                             results.records.size(), results.suite_name)) +
                fmt::format(
                    "set style textbox opaque noborder margins 0.4,0.2\nset logscale x 2\nset "
                    "xrange [{}:{}]\nset xtics {},2,{}\n",
                    0.85 * left, 1.18 * right, left, right) +
                axes + plot + "\n";
  figure.data = data.text();
  return figure;
}

}  // namespace glissade
