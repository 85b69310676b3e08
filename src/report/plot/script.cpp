// SPDX-License-Identifier: GPL-3.0-or-later
#include "plot/script.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "glissade/core/finite.hpp"
#include "glissade/core/wrap.hpp"
#include "glissade/report/format.hpp"
#include "page/symbols.hpp"
#include "plot/labels.hpp"

namespace glissade::gnuplot {
namespace {

constexpr double px_per_inch = 120.0;

bool has_numbers(const DataSeries& series) { return !series.x.empty(); }

/// As gnuplot takes it for sure: an axis has an extent.
Axis drawable(Axis axis) {
  if (std::isfinite(axis.low) && std::isfinite(axis.high) && axis.low < axis.high) return axis;
  axis.low = 0.0;
  axis.high = 1.0;
  return axis;
}

/// Labels of ticks are formats of gnuplot, where % has a meaning.
std::string as_format(const std::string& label) {
  std::string format;
  for (const char c : label) format += c == '%' ? std::string("%%") : std::string(1, c);
  return format;
}

/// Characters in a line of a heading that is as wide as the figure.
constexpr std::size_t title_width = 78, panel_title_width = 28, below_width = 90;
/// Of a tick of the y axis, beside one of two panels in a row, and beside a single one.
constexpr std::size_t tick_width = 18, single_tick_width = 30;

/// In lines of at most `width` characters, nearly equal ones. A number stays with its unit, and the
/// name of a standard is whole.
std::vector<std::string> even_lines(std::string text, std::size_t width) {
  constexpr std::string_view no_break_space = "\u00a0", standard = "ASCE 7-";
  for (std::size_t i = 1; i + 1 < text.size(); ++i) {
    const bool of_number =
        std::isdigit(static_cast<unsigned char>(text[i - 1])) != 0 &&
        (text[i + 1] == '%' || std::isalpha(static_cast<unsigned char>(text[i + 1])) != 0);
    const bool of_standard = i >= 4 && text.compare(i - 4, standard.size(), standard) == 0;
    if (text[i] == ' ' && (of_number || of_standard)) text.replace(i, 1, no_break_space);
  }
  std::vector<std::string> lines = wrapped(text, width);
  while (lines.size() > 1 && width > 1) {
    std::vector<std::string> narrower = wrapped(text, --width);
    if (narrower.size() > lines.size()) break;
    lines = std::move(narrower);
  }
  return lines;
}

/// The text in lines no longer than the figure is wide.
void add_lines(Script& script, const std::string& text, std::size_t width, Quoted::Weight weight) {
  const std::vector<std::string> lines = even_lines(text, width);
  for (std::size_t i = 0; i < lines.size(); ++i)
    script.add("{}{}", i == 0 ? Word("") : Word(".\"\\n\"."), Quoted(lines[i], weight));
}

/// Labels in lines of at most `width` characters.
void add_ticks(Script& script, const std::vector<Tick>& ticks, std::size_t width) {
  script.add("(");
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    if (i > 0) script.add(", ");
    add_lines(script, as_format(ticks[i].label), width, Quoted::Weight::plain);
    script.add(" {}", ticks[i].at);
  }
  script.add(")\n");
}

void add_axis(Script& script, Word which, const Axis& axis, std::size_t label_width,
              std::size_t tick_width) {
  const std::string_view name = which.text;
  // An empty second line below the x axis keeps the key away from it.
  script.add("set {}label ", which);
  add_lines(script, axis.label, label_width, Quoted::Weight::plain);
  script.add("{}\n", name == "x" ? Word(".\"\\n \"") : Word(""));
  script.add("set {}range [{}:{}]\n", which, axis.low, axis.high);
  script.add("set {}tics out nomirror ", which);
  if (axis.ticks.empty()) {
    script.add("autofreq norotate\n");
  } else {
    std::size_t characters = 0;
    for (const Tick& tick : axis.ticks) characters += tick.label.size() + 2;
    const bool turned = name == "x" && characters > label_width;  // else they touch
    script.add("{}", turned ? Word("rotate by 30 right ") : Word(""));
    add_ticks(script, axis.ticks, tick_width);
  }
}

/// Lines across and text; the key of a rule is a key entry.
void add_rules_and_notes(Script& script, const Panel& panel) {
  script.add("unset arrow\nunset label\n");
  // gnuplot's SVG gives lines of one colour and one width the dashes of the first.
  double wider = 0.0;
  for (const Rule& rule : panel.rules) {
    const bool level = rule.kind == Rule::Kind::horizontal;
    const Axis& along = level ? panel.x : panel.y;
    const bool part = rule.from < rule.to;
    const double from = part ? rule.from : along.low, to = part ? rule.to : along.high;
    const Axis& across = level ? panel.y : panel.x;
    if (!(rule.at >= across.low && rule.at <= across.high)) continue;
    if (level)
      script.add("set arrow from {0},{2} to {1},{2}", from, to, rule.at);
    else
      script.add("set arrow from {2},{0} to {2},{1}", from, to, rule.at);
    script.add(" nohead dt {} lw {} lc rgb {} back\n", rule.look.dash, rule.look.width + wider,
               rule.look.colour);
    wider += 0.01;
  }
  for (const Note& note : panel.notes) {
    if (!std::isfinite(note.x) || !std::isfinite(note.y)) continue;
    const Word align = note.align == Note::Align::left    ? Word("left")
                       : note.align == Note::Align::right ? Word("right")
                                                          : Word("center");
    script.add("set label {} at {},{} {} front boxed textcolor rgb {}\n", Quoted(note.text), note.x,
               note.y, align, note.colour);
  }
}

/// `with ...` of a series, or of its entry in the key.
void add_style(Script& script, DataSeries::Kind kind, const Look& look, bool key) {
  switch (kind) {
    case DataSeries::Kind::line:
      script.add("with lines lw {} dt {} lc rgb {}", look.width, look.dash, look.colour);
      return;
    case DataSeries::Kind::points:
      script.add("with points pt {} ps {} lw 2 lc rgb {}", look.symbol, look.symbol_size,
                 look.colour);
      return;
    case DataSeries::Kind::line_and_points:
      script.add("with linespoints lw {} dt {} pt {} ps {} lc rgb {}", look.width, look.dash,
                 look.symbol, look.symbol_size, look.colour);
      return;
    case DataSeries::Kind::bars:
      script.add("with {} lw 1.5 lc rgb {}", key ? Word("lines") : Word("vectors nohead"),
                 look.colour);
      return;
    case DataSeries::Kind::band:
      script.add("with filledcurves fc rgb {}", look.colour);
      return;
    case DataSeries::Kind::area:
      script.add("with filledcurves {}fs solid 0.35 fc rgb {}", key ? Word("") : Word("closed "),
                 look.colour);
      return;
  }
}

struct KeyEntry {
  DataSeries::Kind kind;
  Look look;
  std::string label;
};

/// Of all panels, each entry once.
std::vector<KeyEntry> key_of(const Figure& figure) {
  std::vector<KeyEntry> key;
  const auto add = [&](DataSeries::Kind kind, const Look& look, const std::string& label) {
    const bool is_in = std::ranges::any_of(
        key, [&](const KeyEntry& entry) { return entry.label == label && entry.look == look; });
    if (!label.empty() && !is_in) key.push_back({kind, look, label});
  };
  for (const Panel& panel : figure.panels)
    for (const DataSeries& series : panel.series) add(series.kind, series.look, series.label);
  for (const Panel& panel : figure.panels)
    for (const Rule& rule : panel.rules) add(DataSeries::Kind::line, rule.look, rule.label);
  return key;
}

void add_key(Script& script, const std::vector<KeyEntry>& key) {
  for (const KeyEntry& entry : key) {
    script.add(", \\\n  keyentry ");
    add_style(script, entry.kind, entry.look, true);
    script.add(" title {}", Quoted(entry.label));
  }
  script.add("\n");
}

/// All series, lowest first; `index` counts the blocks of the data file.
void add_plot(Script& script, const FileName& name, const Panel& panel, int& index) {
  // What is infinite leaves the panel.
  const double outside = panel.y.high + 9.0 * (panel.y.high - panel.y.low);
  const bool logarithms = panel.y.values == Axis::Values::logarithms;
  if (logarithms)
    script.add(
        "shown(c) = stringcolumn(c) eq 'inf' ? {} : column(c) > 10**({}) ? log10(column(c)) : "
        "column(c) <= 10**({}) ? {} : NaN\n",
        outside, panel.y.low, panel.y.low, panel.y.low);
  else
    script.add("shown(c) = stringcolumn(c) eq 'inf' ? {} : column(c)\n", outside);
  script.add("plot \\\n  NaN notitle");  // axes, even where there is nothing to draw
  for (const DataSeries& series : panel.series) {
    if (!has_numbers(series)) continue;
    const bool bars = series.kind == DataSeries::Kind::bars,
               band = series.kind == DataSeries::Kind::band;
    script.add(", \\\n  '{}.dat' index {} using ", name, index++);
    if (series.aside == 0.0)
      script.add("1");
    else
      script.add("($1+({}))", series.aside);
    script.add("{} ", band         ? Word(":(shown(2)):(shown(3))")
                      : bars       ? Word(":(shown(2)):(0):(shown(3)-shown(2))")
                      : logarithms ? Word(":(shown(2))")
                                   : Word(":2"));
    add_style(script, series.kind, series.look, false);
  }
}

bool has_several(const Figure& figure) { return figure.panels.size() > 1; }
/// The key stands in the place of the panel that would fill the last row.
bool has_free_place(const Figure& figure) {
  return has_several(figure) && figure.panels.size() % 2 == 1;
}

int key_columns(const Figure& figure, const std::vector<KeyEntry>& key) {
  if (!has_several(figure)) return figure.key_columns;
  constexpr std::size_t characters = 56;  // besides samples of lines
  std::size_t widest = 1;
  for (const KeyEntry& entry : key) widest = std::max(widest, display_width(entry.label));
  return has_free_place(figure) || 2 * widest > characters ? 1 : 2;
}

int key_rows(const Figure& figure, const std::vector<KeyEntry>& key) {
  const int columns = key_columns(figure, key);
  return (static_cast<int>(key.size()) + columns - 1) / columns;
}

int title_lines(const Figure& figure) {
  std::size_t lines = 1;
  for (const Panel& panel : figure.panels)
    lines = std::max(lines, even_lines(panel.title, panel_title_width).size());
  return static_cast<int>(lines);
}

/// Of the heading beyond the usual two lines.
int more_heading_px(const Figure& figure) {
  constexpr int line_px = 20;
  const std::size_t lines =
      even_lines(figure.title, title_width).size() + even_lines(figure.below, below_width).size();
  return line_px * (static_cast<int>(lines) - 2);
}

/// Characters of a label of the y axis, as long as that is high.
std::size_t label_width(const Figure& figure) {
  return has_several(figure) ? 34 : static_cast<std::size_t>(figure.plot_height_px) / 14;
}

/// Heights of a figure and its parts.
struct Heights {
  int heading_px, panel_px, key_px, all_px;
};

Heights heights_of(const Figure& figure) {
  // Of the 30 px of an entry below a single panel 6 are taken from the panel.
  constexpr int title_px = 40, line_px = 30;
  const int key_px = line_px * key_rows(figure, key_of(figure));
  Heights heights{more_heading_px(figure), figure.plot_height_px, key_px * 4 / 5, 0};
  int rows = 1;
  if (has_several(figure)) {
    heights.heading_px += 60;
    heights.key_px = has_free_place(figure) || key_px == 0 ? 0 : key_px + 10;
    heights.panel_px = 420 + title_px * (title_lines(figure) - 1);
    rows = (static_cast<int>(figure.panels.size()) + 1) / 2;
  }
  heights.all_px = heights.heading_px + rows * heights.panel_px + heights.key_px;
  return heights;
}

/// The part of the figure where panel `i` of several stands, two in a row.
void add_place(Script& script, const Heights& heights, std::size_t i) {
  const int bottom_px = heights.heading_px + (static_cast<int>(i) / 2 + 1) * heights.panel_px;
  script.add("set origin {},{}\nset size 0.5,{}\n", i % 2 == 0 ? 0.0 : 0.5,
             1.0 - static_cast<double>(bottom_px) / heights.all_px,
             static_cast<double>(heights.panel_px) / heights.all_px);
}

/// One for all panels, where there are no axes.
void add_shared_key(Script& script, const Figure& figure, const Heights& heights) {
  const std::vector<KeyEntry> key = key_of(figure);
  if (key.empty()) return;
  if (has_free_place(figure))
    add_place(script, heights, figure.panels.size());
  else
    script.add("set origin 0,0\nset size 1,{}\n",
               static_cast<double>(heights.key_px) / heights.all_px);
  script.add(
      "unset border\nunset xtics\nunset ytics\nunset xlabel\nunset ylabel\nunset title\n"
      "unset arrow\nunset label\nset margins 8,0,0,{}\n"
      "set key inside left top vertical maxrows {} maxcols {}\nplot \\\n  [0:1] [0:1] NaN notitle",
      has_free_place(figure) ? Word("6") : Word("0"), key_rows(figure, key),
      key_columns(figure, key));
  add_key(script, key);
}

void add_panels(Script& script, const Figure& figure) {
  const bool several = has_several(figure);
  const Heights heights = heights_of(figure);
  script.add("{}", several ? Word("set multiplot title ") : Word("set title "));
  add_lines(script, figure.title, title_width, Quoted::Weight::bold);
  script.add(".\"\\n\".");
  add_lines(script, figure.below, below_width, Quoted::Weight::plain);
  script.add("\n");
  if (several)  // all panels are of the same size
    script.add("set margins -1,-1,4.5,{}\n", 1.8 + 1.1 * title_lines(figure));
  int index = 0;
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    Panel panel = figure.panels[i];
    panel.x = drawable(panel.x);
    panel.y = drawable(panel.y);
    if (several) {
      add_place(script, heights, i);
      script.add("set title ");
      add_lines(script, panel.title, panel_title_width, Quoted::Weight::bold);
      script.add("\n");
    }
    script.add("set border 3 lc rgb '#444444'\n");
    const std::size_t x_width = several ? 44 : below_width;
    add_axis(script, "x", panel.x, x_width, x_width);
    add_axis(script, "y", panel.y, label_width(figure), several ? tick_width : single_tick_width);
    add_rules_and_notes(script, panel);
    add_plot(script, figure.name, panel, index);
    add_key(script, several ? std::vector<KeyEntry>{} : key_of(figure));
  }
  if (!several) return;
  add_shared_key(script, figure, heights);
  script.add("unset multiplot\n");
}

}  // namespace

namespace {

/// Of a symbol that begins at `at`, "S_D1"; 0 where none does, or it is of a word or the user's.
std::size_t symbol_at(std::string_view whole, std::size_t at) {
  const std::string_view text = whole.substr(at);
  const auto is_of_word = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
  };
  if (at > 0 && is_of_word(whole[at - 1])) return 0;
  for (const std::string_view symbol :
       {"S_DS", "S_D1", "S_MS", "S_M1", "S_S", "S_1", "S_a", "\u03b1_0"}) {
    const bool ends = text.size() == symbol.size() ||
                      (text.size() > symbol.size() && !is_of_word(text[symbol.size()]));
    if (text.starts_with(symbol) && ends) return UserTexts::have(symbol) ? 0 : symbol.size();
  }
  return 0;
}

}  // namespace

FileName identifier(const FileName& name) {
  std::string text = name.text();
  std::ranges::replace(text, '-', '_');
  return text;
}

Quoted::Quoted(std::string_view plain, Weight weight) {
  quoted_ = weight == Weight::bold ? "'{/:Bold " : "'";
  for (std::size_t i = 0; i < plain.size(); ++i) {
    const char c = plain[i];
    const std::size_t symbol = symbol_at(plain, i);
    if (symbol > 0) {  // gnuplot sets a subscript at 0.8 of the size
      const std::size_t index = plain.find('_', i) + 1;
      quoted_ += std::string(plain.substr(i, index - i)) + "{/*1.15 " +
                 std::string(plain.substr(index, i + symbol - index)) + "}";
      i += symbol - 1;
      if (plain.substr(i + 1).starts_with(' ')) {
        quoted_ += "\u00a0";  // SVG readers drop a plain space at the end of a subscript
        ++i;
      }
    } else if (c == '\'') {
      quoted_ += "\u2019";  // gnuplot does not take every doubled quote as one
    } else if (std::string_view("_^{}@&~\\").find(c) != std::string_view::npos) {
      quoted_ += std::string("\\") + c;
    } else {
      quoted_ += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? ' ' : c;
    }
  }
  quoted_ += weight == Weight::plain ? "'" : "}'";
}

namespace {

/// Numbers of logarithmic axes in place of their logarithms.
Panel in_logarithms(Panel panel) {
  if (panel.y.values != Axis::Values::logarithms) return panel;
  const double low = std::log10(panel.y.low);
  const auto to_logarithm = [low](double& y) {
    if (!std::isnan(y)) y = y > 0.0 ? std::max(low, std::log10(y)) : low;
  };
  for (DataSeries& series : panel.series)
    for (std::vector<double>* values : {&series.y, &series.low, &series.high})
      std::ranges::for_each(*values, to_logarithm);
  for (Rule& rule : panel.rules)
    if (rule.kind == Rule::Kind::horizontal) to_logarithm(rule.at);
  for (Note& note : panel.notes) to_logarithm(note.y);
  for (Tick& tick : panel.y.ticks) to_logarithm(tick.at);
  to_logarithm(panel.y.low);
  to_logarithm(panel.y.high);
  return panel;
}

/// As it is drawn: with the logarithms of logarithmic axes and the labels of lines.
Figure labelled(Figure figure) {
  std::ranges::transform(figure.panels, figure.panels.begin(), in_logarithms);
  if (!figure.labels_at_lines) return figure;
  const PanelSize size = has_several(figure) ? PanelSize{330.0, 270.0}
                                             : PanelSize{730.0, figure.plot_height_px - 210.0};
  for (Panel& panel : figure.panels) {
    panel.x = drawable(panel.x);
    panel.y = drawable(panel.y);
    label_lines(panel, size);
  }
  return figure;
}

void add_output(Script& script, const Figure& figure, Word ending, int descriptor) {
  if (descriptor < 0)
    script.add("set output '{}.{}'\n", figure.name, ending);
  else
    script.add("set output '/dev/fd/{}'\n", descriptor);
}

}  // namespace

std::string script_of(const Figure& unlabelled, const Drawings& to) {
  const Figure figure = labelled(unlabelled);
  // As wide as a printed page has room for letters of 9 pt and more.
  const int width_px = 840, height_px = heights_of(figure).all_px;
  Script script;
  script.add(
      "# Draw again with: gnuplot {}.gp\n"
      "set encoding utf8\n"
      "set grid lc rgb '#dddddd' lt 1 lw 0.7\n"
      "set key bmargin left {} maxcols {} Left reverse noautotitle samplen 3 spacing 1.2\n"
      "set style fill transparent solid 0.16 noborder\n"
      "set style textbox opaque noborder margins 0.4,0.2\n",
      figure.name, figure.key_columns > 1 ? Word("horizontal") : Word("vertical"),
      figure.key_columns);
  script.add(
      "set terminal svg enhanced dynamic size {},{} background rgb 'white' font 'Arial,16' "
      "name '{}'\n",
      width_px, height_px, identifier(figure.name));
  add_output(script, figure, "svg", to.svg);
  add_panels(script, figure);
  script.add(
      "set terminal pdfcairo enhanced color size {:.3f},{:.3f} background rgb 'white' "
      "font 'Arial,9.5' fontscale 0.75\n",  // 9.5 pt; the usual 0.5 gives 6.3
      width_px / px_per_inch, height_px / px_per_inch);
  add_output(script, figure, "pdf", to.pdf);
  if (has_several(figure)) {
    add_panels(script, figure);
    return script.str();
  }
  if (wrapped(figure.panels[0].y.label, label_width(figure)).size() > 1)
    script.add("set lmargin 9\nset ylabel offset -1\n");  // this terminal has room for one line
  script.add("replot\n");
  return script.str();
}

std::string data_of(const Figure& figure) {
  std::string data;
  const auto one_line = [](std::string text) {
    std::ranges::replace_if(
        text, [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
    return text;
  };
  for (const Panel& panel : figure.panels) {
    for (const DataSeries& series : panel.series) {
      if (!has_numbers(series)) continue;
      if (!data.empty()) data += "\n\n";
      const bool spread = !series.low.empty();
      data += "# " + one_line(series.name) + "\n# columns" +
              (!series.source.empty() ? " of " + one_line(series.source)
               : spread               ? ": x low high"
                                      : ": x y") +
              "\n";
      for (std::size_t i = 0; i < series.x.size(); ++i) {
        const auto column = [](double v) { return std::isfinite(v) ? format_exact(v) : "nan"; };
        if (!std::isfinite(series.x[i])) {
          data += "\n";  // the line ends; the next row starts another
          continue;
        }
        const auto end = [&](double v) { return v == infinity ? "inf" : column(v); };
        data += column(series.x[i]) + " ";
        data +=
            spread ? end(series.low.at(i)) + " " + end(series.high.at(i)) : column(series.y.at(i));
        data += "\n";
      }
    }
  }
  return data;
}

}  // namespace glissade::gnuplot
