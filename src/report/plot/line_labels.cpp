// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>

#include "glissade/core/wrap.hpp"
#include "plot/labels.hpp"

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

/// A text of a rule, above or below it.
struct LabelPlace {
  Note note;
  double left, right, low, high;
  bool holds(double x, double y) const { return left < x && x < right && low < y && y < high; }
  bool meets(double x, double from, double to) const {
    return left < x && x < right && from < high && to > low;
  }
};

/// How many points of lines and bands, notes and other rules it hides or parts from its rule.
int hidden(const Panel& panel, const Rule& rule, const LabelPlace& place) {
  int count = 0;
  constexpr int parts = 16;
  for (const DataSeries& series : panel.series) {
    const bool has_y = !series.y.empty();
    for (std::size_t i = 1; i < series.x.size(); ++i) {
      const auto between = [&](const std::vector<double>& values, int part) {
        return std::lerp(values[i - 1], values[i], static_cast<double>(part) / parts);
      };
      for (int part = 0; part <= parts; ++part) {
        const double x = between(series.x, part);
        count += has_y ? place.holds(x, between(series.y, part))
                       : place.meets(x, between(series.low, part), between(series.high, part));
      }
    }
  }
  for (const Note& note : panel.notes) count += 1000 * place.holds(note.x, note.y);
  const double low = std::min(place.low, rule.at), high = std::max(place.high, rule.at);
  for (const Rule& other : panel.rules)
    count += 100 * (&other != &rule && low < other.at && other.at < high);
  return count;
}

/// Where the rule's label hides nothing: at its ends, else along it.
std::optional<LabelPlace> free_place(const Panel& panel, const Rule& rule, double text,
                                     double line) {
  const double margin = 0.01 * (panel.x.high - panel.x.low), from = rule.from + margin,
               to = rule.to - margin - text;
  for (const double share : {0.0, 1.0, 0.5, 0.25, 0.75, 0.125, 0.375, 0.625, 0.875}) {
    for (const double side : {1.0, -1.0}) {
      const bool at_right = share == 1.0;
      const double left = std::lerp(from, to, share), right = left + text,
                   y = rule.at + side * line;
      const LabelPlace place{{at_right ? right : left, y, rule.label, rule.look.colour,
                              at_right ? Note::Align::right : Note::Align::left},
                             left,
                             right,
                             y - 0.6 * line,
                             y + 0.6 * line};
      const bool inside = left >= panel.x.low && right <= panel.x.high &&
                          place.high <= panel.y.high && place.low >= panel.y.low;
      if (inside && hidden(panel, rule, place) == 0) return place;
    }
  }
  return {};
}

/// The margin takes its share of the panel as it is drawn.
double share_of(const std::vector<Note>& at_edge, const PanelSize& size) {
  double widest = 0.0;
  for (const Note& note : at_edge) widest = std::max(widest, text_px(note.text) + 2 * character_px);
  return std::min(0.6, widest / size.width_px);
}

/// A thin line from the rule's end to its label at the edge.
Rule leader_of(const Panel& panel, const Rule& rule) {
  Rule leader = rule;
  leader.label.clear();
  leader.look.width = 0.8;
  leader.look.dash = 3;
  leader.from = rule.to;
  leader.to = panel.x.high;
  return leader;
}

/// Labels the rules where there is room beside a margin of this share. Returns the first one that
/// has none but could be labelled in the margin.
Rule* label_rules(Panel& panel, const PanelSize& size, double share) {
  const double px = (panel.x.high - panel.x.low) / ((1.0 - share) * size.width_px);
  const double line = 0.8 * line_px / size.height_px * (panel.y.high - panel.y.low);
  for (Rule& rule : panel.rules) {
    if (rule.kind != Rule::Kind::horizontal || rule.label.empty()) continue;
    if (const auto place = free_place(panel, rule, px * text_px(rule.label), line)) {
      panel.notes.push_back(place->note);
      rule.label.clear();
    } else if (rule.at <= panel.y.high && text_px(rule.label) < 0.4 * size.width_px) {
      return &rule;
    }
  }
  return nullptr;
}

}  // namespace

void label_lines(Panel& panel, const PanelSize& size) {
  std::vector<Note> at_edge = take_labels(panel, size);
  for (Rule& rule : panel.rules) {
    if (rule.kind != Rule::Kind::horizontal || rule.from < rule.to) continue;
    rule.from = panel.x.low;
    rule.to = panel.x.high;
  }
  for (;;) {
    Panel labelled = panel;
    const Rule* crowded = label_rules(labelled, size, share_of(at_edge, size));
    if (crowded == nullptr) {
      panel = std::move(labelled);
      break;
    }
    // To the margin, which then takes more of the panel.
    Rule& rule = panel.rules[static_cast<std::size_t>(crowded - labelled.rules.data())];
    at_edge.push_back({panel.x.high, rule.at, rule.label, rule.look.colour, Note::Align::left});
    rule.label.clear();
    const Rule leader = leader_of(panel, rule);
    if (leader.from < leader.to) panel.rules.push_back(leader);
  }
  if (at_edge.empty()) return;
  const double share = share_of(at_edge, size);
  add_side_labels(panel, std::move(at_edge),
                  {Side::right, share / (1.0 - share), line_px / size.height_px});
}

}  // namespace glissade
