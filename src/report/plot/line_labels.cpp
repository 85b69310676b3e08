// SPDX-License-Identifier: GPL-3.0-or-later
#include "plot/line_labels.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "glissade/core/wrap.hpp"

namespace glissade {
namespace {

constexpr double character_px = 9.0, line_px = 22.0;

double text_px(const std::string& text) {
  return character_px * static_cast<double>(display_width(text));
}

/// Of one line or its points, the last point that is drawn.
std::optional<std::size_t> end_of(const Panel& panel, const DataSeries& series) {
  using enum DataSeries::Kind;
  if (series.kind != line && series.kind != points && series.kind != line_and_points) return {};
  if (std::ranges::any_of(series.x, [](double x) { return std::isnan(x); })) return {};  // several
  for (std::size_t i = series.y.size(); i-- > 0;)
    if (series.x[i] <= panel.x.high && series.y[i] <= panel.y.high) return i;  // NaN is not
  return {};
}

/// Beside its point, or lower, clear of other notes.
void add_note(Panel& panel, Note note, const PanelSize& size) {
  const double x_per_px = (panel.x.high - panel.x.low) / size.width_px,
               line = line_px * (panel.y.high - panel.y.low) / size.height_px;
  const auto is_hidden = [&](const Note& other) {
    const Note& left = other.x < note.x ? other : note;
    return std::abs(other.x - note.x) < x_per_px * text_px(left.text) &&
           std::abs(other.y - note.y) < 0.9 * line;
  };
  while (std::ranges::any_of(panel.notes, is_hidden)) note.y -= line;
  panel.notes.push_back(std::move(note));
}

/// Takes the labels at the right edge; those of lines that end before it are added there.
std::vector<Note> take_labels(Panel& panel, const PanelSize& size) {
  const double width = panel.x.high - panel.x.low;
  std::vector<Note> at_edge;
  for (DataSeries& series : panel.series) {
    const auto end = end_of(panel, series);
    if (!end || series.label.empty()) continue;
    Note note{series.x[*end], series.y[*end], series.label, series.look.colour, Note::Align::left};
    series.label.clear();
    if (note.x >= panel.x.high - 0.2 * width) {
      at_edge.push_back(std::move(note));
    } else {
      note.x += 0.02 * width;
      add_note(panel, std::move(note), size);
    }
  }
  return at_edge;
}

/// A text of a rule at one of its ends, above or below it.
struct LabelPlace {
  Note note;
  double left, right, low, high;
  bool holds(double x, double y) const { return left < x && x < right && low < y && y < high; }
};

/// How many points of lines and notes it hides.
int hidden(const Panel& panel, const LabelPlace& place) {
  int count = 0;
  for (const DataSeries& series : panel.series) {
    for (std::size_t i = 1; i < series.y.size(); ++i) {
      constexpr int parts = 16;
      for (int part = 0; part <= parts; ++part) {
        const double share = static_cast<double>(part) / parts;
        count += place.holds(std::lerp(series.x[i - 1], series.x[i], share),
                             std::lerp(series.y[i - 1], series.y[i], share));
      }
    }
  }
  for (const Note& note : panel.notes) count += 1000 * place.holds(note.x, note.y);
  for (const Rule& rule : panel.rules) count += 100 * (place.low < rule.at && rule.at < place.high);
  return count;
}

void label_rule(Panel& panel, Rule& rule, double text, double line) {
  if (rule.from >= rule.to) {
    rule.from = panel.x.low;
    rule.to = panel.x.high;
  }
  const double margin = 0.01 * (panel.x.high - panel.x.low);
  std::optional<LabelPlace> best;
  int least = 0;
  for (const bool at_left : {true, false}) {
    for (const double side : {1.0, -1.0}) {
      const double x = at_left ? rule.from + margin : rule.to - margin, y = rule.at + side * line;
      const LabelPlace place{
          {x, y, rule.label, rule.look.colour, at_left ? Note::Align::left : Note::Align::right},
          at_left ? x : x - text,
          at_left ? x + text : x,
          y - 0.6 * line,
          y + 0.6 * line};
      const bool inside =
          place.left >= panel.x.low && place.high <= panel.y.high && place.low >= panel.y.low;
      const int count = hidden(panel, place);
      if (!inside || (best && count >= least)) continue;
      best = place;
      least = count;
    }
  }
  if (!best) return;
  panel.notes.push_back(best->note);
  rule.label.clear();
}

}  // namespace

void label_lines(Panel& panel, const PanelSize& size) {
  std::vector<Note> at_edge = take_labels(panel, size);
  double widest = 0.0;
  for (const Note& note : at_edge) widest = std::max(widest, text_px(note.text) + 2 * character_px);
  // The margin takes its share of the panel as it is drawn.
  const double share = std::min(0.6, widest / size.width_px), margin = share / (1.0 - share);
  const double px = (1.0 + margin) * (panel.x.high - panel.x.low) / size.width_px;
  const double line = line_px / size.height_px;
  for (Rule& rule : panel.rules)
    if (rule.kind == Rule::Kind::horizontal && !rule.label.empty())
      label_rule(panel, rule, px * text_px(rule.label), 0.8 * line * (panel.y.high - panel.y.low));
  if (!at_edge.empty()) add_side_labels(panel, std::move(at_edge), {Side::right, margin, line});
}

}  // namespace glissade
