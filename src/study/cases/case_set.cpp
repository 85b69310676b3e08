// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/cases/case_set.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string_view>
#include <utility>

#include "glissade/core/contract.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/hash.hpp"
#include "glissade/core/units.hpp"
#include "glissade/study/cases/sample_points.hpp"
#include "glissade/study/config.hpp"

namespace glissade {
namespace {

/// An axis, and how a value of it is put into a case.
struct ListedQuantity {
  CaseAxis axis;
  std::function<void(Case&, std::size_t)> put;
};

template <class E>
void add_choices(std::vector<ListedQuantity>& axes, const char* key, const std::vector<E>& choices,
                 const std::vector<std::string>& names, const std::vector<std::string>& described,
                 E Case::*member) {
  ListedQuantity axis{{key, "-", {}, {}, {}},
                      [choices, member](Case& c, std::size_t i) { c.*member = choices[i]; }};
  for (const E choice : choices) {
    axis.axis.values.push_back(static_cast<double>(choice));
    axis.axis.names.push_back(names[static_cast<std::size_t>(choice)]);
    axis.axis.described.push_back(described[static_cast<std::size_t>(choice)]);
  }
  axes.push_back(std::move(axis));
}

bool friction_is_drawn(const StudyConfig& config) {
  return config.quantities.at("friction", "mu").is_drawn() ||
         (config.friction.across_is_given &&
          config.quantities.at("friction", "across_mu").is_drawn());
}

/// Every quantity with its values, also those that have one.
std::vector<ListedQuantity> axes_of(const StudyConfig& config) {
  std::vector<ListedQuantity> axes;
  std::vector<FrictionValue> friction{FrictionValue::as_drawn};
  if (friction_is_drawn(config)) friction = config.friction.values;
  add_choices(axes, "friction.value", friction, {"sampled", "design"},
              {"sampled friction", "design friction"}, &Case::friction_value);
  add_choices(axes, "array.support", config.support, {"isolated", "anchored", "no_array"},
              {"isolated array", "anchored array", "no array"}, &Case::support);
  add_choices(axes, "vertical.use", config.vertical, {"none", "if_available", "required"},
              {"vertical motion none", "vertical motion if available", "vertical motion required"},
              &Case::vertical);
  for (std::size_t i = 0; i < parameters().size(); ++i) {
    const Parameter& p = parameters()[i];
    const Quantity& quantity = config.quantities[i];
    if (quantity.is_drawn()) continue;
    axes.push_back(
        {{p.name(), p.unit, quantity.values, {}, {}},
         [&p, values = quantity.values](Case& c, std::size_t k) { p.of(c) = values[k]; }});
  }
  return axes;
}

std::vector<Orientation> orientations_of(const StudyConfig& config) {
  const OrientationConfig& o = config.orientation;
  if (o.choice == OrientationChoice::random) {
    std::vector<Orientation> by_axis;
    for (const SlopeAxis axis : o.slope_axis) by_axis.push_back({axis, 0.0, 1});
    return by_axis;
  }
  std::vector<Orientation> all = orientations(o.choice, o.slope_axis);
  // Along one axis nothing acts across.
  if (!config.two_axes())
    std::erase_if(all, [](const Orientation& orientation) { return orientation.across_sign < 0; });
  return all;
}

}  // namespace

std::size_t CaseGrid::combinations() const {
  std::size_t count = 1;
  for (const CaseAxis& axis : axes) count *= axis.size();
  return count;
}

std::vector<std::size_t> CaseGrid::places(std::size_t combination) const {
  std::vector<std::size_t> places(axes.size());
  for (std::size_t i = axes.size(); i > 0; --i) {
    places[i - 1] = combination % axes[i - 1].size();
    combination /= axes[i - 1].size();
  }
  return places;
}

std::size_t CaseGrid::combination(const std::vector<std::size_t>& places) const {
  GLISSADE_EXPECTS(places.size() == axes.size());
  std::size_t combination = 0;
  for (std::size_t i = 0; i < axes.size(); ++i)
    combination = combination * axes[i].size() + places[i];
  return combination;
}

std::size_t CaseGrid::axis(const std::string& key) const {
  return static_cast<std::size_t>(std::ranges::find(axes, key, &CaseAxis::key) - axes.begin());
}

namespace {

/// So many significant digits, or as many as distinguish the value from the others.
std::string short_text(const std::vector<double>& values, std::size_t i, int digits) {
  const auto text = [&](double value) { return fmt::format("{:.{}g}", value, digits); };
  const auto alike =
      std::ranges::count_if(values, [&](double value) { return text(value) == text(values[i]); });
  return alike == 1 ? text(values[i]) : fmt::format("{}", values[i]);
}

}  // namespace

bool slides_freely(const Case& c) {
  return c.support == ArraySupport::isolated &&
         std::tan(std::abs(c.slope_deg) * rad_per_deg) >= c.friction;
}

OrientationChoice orientation_choice(const CaseSet& set) {
  const auto is_as_recorded = [](const Case& c) {
    return c.orientation.ground_azimuth_deg == 0.0 && c.orientation.across_sign == 1;
  };
  const auto first = set.cases.begin();
  const auto end = first + static_cast<std::ptrdiff_t>(std::min(set.orientations, set.size()));
  if (std::any_of(first, end, [](const Case& c) { return !c.orientation.is_quarter_turn(); }) &&
      set.orientations > 1)
    return OrientationChoice::azimuths;
  if (std::ranges::all_of(set.cases, is_as_recorded)) return OrientationChoice::as_recorded;
  constexpr std::size_t slope_axes = 2;
  return set.orientations > slope_axes ? OrientationChoice::all_permutations
                                       : OrientationChoice::random;
}

std::string CaseSet::label(std::size_t combination) const {
  constexpr std::size_t room = 48;  // a FileName with the name of a table or figure before it
  const std::vector<std::size_t> place = places(combination);
  std::string label;
  std::size_t longest = 0;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const auto part = [&axis = axes[i]](std::size_t at) {
      return axis.names.empty()
                 ? axis.key.substr(axis.key.find('.') + 1) + "_" + short_text(axis.values, at, 6)
                 : axis.names[at];
    };
    std::size_t widest = 0;
    for (std::size_t at = 0; at < axes[i].size(); ++at) widest = std::max(widest, part(at).size());
    longest += widest + 1;
    label += (label.empty() ? "" : "_") + part(place[i]);
  }
  if (longest > room) return fmt::format("combination_{}", combination + 1);
  // Of what stands in a file's name.
  std::ranges::replace_if(
      label, [](char c) { return c == '.' || c == '+'; }, '_');
  if (!label.empty()) return label;
  const Case& first = cases.front();
  if (first.friction_value == FrictionValue::design) return "design";
  return std::ranges::all_of(cases,
                             [&](const Case& c) {
                               return c.friction == first.friction &&
                                      c.friction_across == first.friction_across;
                             })
             ? "constant"
             : "sampled";
}

std::string CaseAxis::words() const {
  for (const Parameter& p : parameters()) {
    if (key == p.name()) return p.words;
  }
  return key == "vertical.use" ? "vertical motion" : key.substr(0, key.find('.'));
}

std::string CaseAxis::describe(std::size_t i) const {
  if (!described.empty()) return described[i];
  return words() + " " + short_text(values, i, 3) + (unit == "-" ? "" : " " + unit);
}

std::string CaseGrid::describe(std::size_t combination,
                               const std::vector<std::string>& without) const {
  std::string text;
  const std::vector<std::size_t> place = places(combination);
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (std::ranges::find(without, axes[i].key) != without.end()) continue;
    text += (text.empty() ? "" : ", ") + axes[i].describe(place[i]);
  }
  return text;
}

/// Draws a sample of everything uncertain by its number; what is listed stays as it is.
class SampleDraw {
 public:
  explicit SampleDraw(const StudyConfig& config) : config_(config), points_(config) {
    for (std::size_t i = 0; i < parameters().size(); ++i)
      if (config.quantities[i].is_drawn()) drawn_.push_back(i);
  }

  std::size_t samples() const { return points_.count(); }

  void store() {
    values_.reserve(samples() * drawn_.size());
    for (std::size_t sample = 0; sample < samples(); ++sample) {
      for (const std::size_t i : drawn_) values_.push_back(value(i, sample));
      if (draws_orientation()) orientations_.push_back(orientation(sample));
    }
  }
  void drop() {
    values_ = {};
    orientations_ = {};
  }

  void put(Case& c, std::size_t sample) const {
    for (std::size_t k = 0; k < drawn_.size(); ++k)
      parameters()[drawn_[k]].of(c) =
          values_.empty() ? value(drawn_[k], sample) : values_[sample * drawn_.size() + k];
    if (!draws_orientation()) return;
    const SlopeAxis slope_axis = c.orientation.slope_axis;
    c.orientation = orientations_.empty() ? orientation(sample) : orientations_[sample];
    c.orientation.slope_axis = slope_axis;
  }

 private:
  bool draws_orientation() const { return config_.orientation.choice == OrientationChoice::random; }

  double value(std::size_t parameter, std::size_t sample) const {
    const Parameter& p = parameters()[parameter];
    const Quantity& quantity = config_.quantities[parameter];
    double value = quantile(*quantity.drawn, points_.coordinate(sample, p.dimension));
    if (quantity.drawn_as_rise_in_12) value = slope_of_rise_deg(value);
    // Tails outside the physical range (less than one in a million) are put at its ends.
    return std::clamp(value, p.range.min, p.range.max);
  }

  Orientation orientation(std::size_t sample) const {
    const OrientationConfig& o = config_.orientation;
    const auto coin = [&](std::uint32_t dimension) {
      return points_.coordinate(sample, dimension) < 0.5;
    };
    const auto sign = [&](SignChoice choice, std::uint32_t dimension) {
      if (choice == SignChoice::positive) return 1;
      if (choice == SignChoice::negative) return -1;
      return coin(dimension) ? 1 : -1;
    };
    int component = o.component == ComponentChoice::second ? 1 : 0;
    if (o.component == ComponentChoice::random) component = coin(component_dimension) ? 0 : 1;
    return quarter_turn({component, sign(o.sign, sign_dimension)},
                        config_.two_axes() ? sign(o.second_sign, second_sign_dimension) : 1);
  }

  StudyConfig config_;
  SamplePoints points_;
  std::vector<std::size_t> drawn_;  ///< parameters
  // Where they are stored:
  std::vector<double> values_;  ///< by (sample, drawn)
  std::vector<Orientation> orientations_;
};

PlannedCases::PlannedCases(const StudyConfig& config) {
  for (ListedQuantity& axis : axes_of(config)) {
    axis.put(usual_, 0);
    if (axis.axis.size() < 2) continue;
    put_.push_back(std::move(axis.put));
    axes.push_back(std::move(axis.axis));
  }
  usual_.neighbour_slope = config.neighbour_slope;
  draw_ = std::make_shared<SampleDraw>(config);
  samples = draw_->samples();
  orientations_ = orientations_of(config);
  orientations = orientations_.size();
  if (size() > std::numeric_limits<CaseNumber>::max())
    throw InputError({config.file, fmt::format("has {:.3g} cases", static_cast<double>(size())),
                      "take fewer samples or combinations: at most 4.29e9 cases", ""});

  const Quantity& along = config.quantities.at("friction", "mu");
  const Quantity& across = config.quantities.at("friction", "across_mu");
  const Quantity& neighbour = config.quantities.at("friction", "neighbour_mu");
  across_is_given_ = config.friction.across_is_given;
  if (along.is_drawn()) design_along_ = design_friction(*along.drawn);
  if (across.is_drawn()) design_across_ = design_friction(*across.drawn);
  if (neighbour.is_drawn()) design_neighbour_ = design_friction(*neighbour.drawn);
}

void PlannedCases::store_draws() { draw_->store(); }
void PlannedCases::drop_draws() { draw_->drop(); }

Case PlannedCases::operator[](std::size_t i) const {
  Case c = usual_;
  c.orientation = orientations_[i % orientations];
  draw_->put(c, i / orientations % samples);
  std::size_t place = i / per_combination();
  for (std::size_t axis = axes.size(); axis > 0; --axis) {
    put_[axis - 1](c, place % axes[axis - 1].size());
    place /= axes[axis - 1].size();
  }
  const bool design = c.friction_value == FrictionValue::design;
  if (design && design_along_) c.friction = *design_along_;
  if (design && design_across_) c.friction_across = *design_across_;
  if (design && design_neighbour_) c.neighbour_friction = *design_neighbour_;
  if (c.neighbour_over_mu > 0.0) c.neighbour_friction = c.neighbour_over_mu * c.friction;
  if (!across_is_given_) c.friction_across = c.friction;
  if (c.orientation.slope_axis == SlopeAxis::n_s) std::swap(c.friction, c.friction_across);
  return c;
}

CaseSet PlannedCases::stored() const {
  CaseSet set{*this, {}};
  set.cases.reserve(size());
  for (const Case& c : all()) set.cases.push_back(c);
  return set;
}

std::vector<CaseNumber> first_with_same_key(
    std::size_t count, const std::function<std::vector<double>(CaseNumber)>& key_of) {
  std::vector<std::pair<std::uint64_t, CaseNumber>> by_hash;
  by_hash.reserve(count);
  for (const CaseNumber i : std::views::iota(CaseNumber{0}, static_cast<CaseNumber>(count)))
    by_hash.emplace_back(Hasher().numbers(key_of(i)).value(), i);
  std::ranges::sort(by_hash);
  std::vector<CaseNumber> first(count);
  for (std::size_t begin = 0, end = 0; begin < count; begin = end) {
    while (end < count && by_hash[end].first == by_hash[begin].first) ++end;
    // Of one hash; different keys are possible.
    std::vector<std::pair<std::vector<double>, CaseNumber>> firsts;
    for (std::size_t k = begin; k < end; ++k) {
      const CaseNumber i = by_hash[k].second;
      first[i] = i;
      if (end - begin == 1) break;
      std::vector<double> key = key_of(i);
      const auto same = std::ranges::find(firsts, key, [](const auto& f) { return f.first; });
      if (same != firsts.end())
        first[i] = same->second;
      else
        firsts.emplace_back(std::move(key), i);
    }
  }
  return first;
}

std::vector<CaseNumber> same_as(const CaseGrid& cases,
                                const std::function<Case(std::size_t)>& case_of, bool two_axes,
                                SampleBlocks blocks) {
  return first_with_same_key(cases.size(), [&](CaseNumber i) {
    const Case c = case_of(i);
    std::vector<double> key{static_cast<double>(cases.block(i, blocks))};
    for (const Parameter& p : parameters()) {
      const bool counts =
          (two_axes || p.axes == Parameter::Axes::any) &&
          (c.vertical != VerticalChoice::none || p.table != std::string_view("vertical"));
      key.push_back(counts ? value_of(p, c) + 0.0 : 0.0);  // -0 is 0
    }
    key.push_back(static_cast<double>(c.support));
    key.push_back(static_cast<double>(c.vertical));
    key.push_back(static_cast<double>(c.neighbour_slope));
    // A neighbour's place is not mirrored.
    const bool mirrors_across = c.azimuth_deg == 0.0 && c.neighbour_friction == 0.0;
    if (two_axes) {
      key.push_back(c.orientation.ground_azimuth_deg);
      key.push_back(mirrors_across ? 1.0 : c.orientation.across_sign);
    } else if (c.orientation.is_quarter_turn()) {
      const SignedComponent along = along_axis(c.orientation, 0);
      key.push_back(along.component);
      key.push_back(c.slope_deg == 0.0 ? 1.0 : along.sign);
    } else {
      key.push_back(2.0 + c.orientation.ground_azimuth_deg);
    }
    return key;
  });
}

}  // namespace glissade
