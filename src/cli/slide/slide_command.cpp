// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <iterator>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "glissade/block/tipping.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/finite.hpp"
#include "glissade/core/units.hpp"
#include "glissade/core/wrap.hpp"
#include "glissade/io/record_file.hpp"
#include "glissade/io/suite_file.hpp"
#include "glissade/motion/improbable.hpp"
#include "glissade/motion/intensity.hpp"
#include "glissade/motion/peak_names.hpp"
#include "glissade/sampling/pull_test.hpp"
#include "glissade/study/cases/probable.hpp"
#include "glissade/study/plan/one_mass.hpp"
#include "shared/finding.hpp"
#include "shared/option_errors.hpp"
#include "shared/put.hpp"
#include "slide/slide_history.hpp"

namespace glissade::cli {
namespace {

/// A text on the keys of a suite, on the options of this command.
std::string with_options(std::string text) {
  for (const auto& [key, option] : {std::pair{"dt_s", "--dt-s"},
                                    {"give units", "give --units"},
                                    {"units says", "--units says"},
                                    {"counts_per_unit", "--counts-per-unit"}}) {
    if (const std::size_t at = text.find(key); at != std::string::npos)
      text.replace(at, std::strlen(key), option);
  }
  return text;
}

Record read_component(const std::string& name, RecordFileOptions options) {
  const ComponentAddress address = split_address(name);
  options.component = address.component;
  return with_changed_problems(
      [](Problem& p) {
        p.what = with_options(p.what);
        p.suggestion = with_options(p.suggestion);
      },
      [&] { return read_record(address.file, options); });
}

/// A component as its file has it.
struct ReadComponent {
  const char* name;
  std::string file;
  Record record;
};

struct ReadMotion {
  Motion motion;
  std::vector<ReadComponent> components;
};

/// A motion of a suite: the options get its components.
ReadMotion motion_of_suite(SlideOptions& o) {
  if (!o.second.empty() || !o.vertical.empty())
    throw InputError({o.second.empty() ? "--vertical" : "--second",
                      o.record + " is a motion of a suite, with all its components",
                      "leave it out, or name the files of the components", ""});
  const auto [file, id] = split_address(o.record);
  const Suite suite = load_suite(file);
  const auto named = std::ranges::find(suite.motions, id, &Motion::id);
  if (named == suite.motions.end()) {
    std::string known;
    for (const Motion& motion : suite.motions) known += (known.empty() ? "" : ", ") + motion.id;
    throw InputError(
        {file, id.empty() ? "is a suite, of which no motion is named" : "has no motion " + id,
         "give " + file + "#ID, ID one of: " + known, ""});
  }
  o.of_roof = suite.of_roof;
  ReadMotion read{*named, {}};
  const auto add = [&](const char* name, const Samples& samples) {
    if (samples.empty()) return std::string();
    const std::string address = o.record + ", " + name;
    read.components.push_back({name, address, {address, named->dt_s, samples, "", {}}});
    return address;
  };
  add("first", named->horizontal_mps2[0]);
  o.second = add("second", named->horizontal_mps2[1]);
  o.vertical = add("vertical", named->vertical_mps2);
  return read;
}

ReadMotion read_motion(const SlideOptions& o) {
  RecordFileOptions file;
  file.dt_s = o.dt_s;
  file.counts_per_unit = o.counts_per_unit;
  if (!o.units.empty()) file.units = parse_acceleration_units(o.units);
  const TimedRecord first{read_component(o.record, file), 0.0};
  std::optional<TimedRecord> second, vertical;
  if (!o.second.empty()) second = TimedRecord{read_component(o.second, file), 0.0};
  if (!o.vertical.empty()) vertical = TimedRecord{read_component(o.vertical, file), 0.0};
  ReadMotion read{
      assemble_motion({.contradictions = source_contradictions(first, second, vertical)}, first,
                      second, vertical),
      {{"first", o.record, first.record}}};
  if (second) read.components.push_back({"second", o.second, second->record});
  if (vertical) read.components.push_back({"vertical", o.vertical, vertical->record});
  return read;
}

using Json = nlohmann::ordered_json;

/// NaN and infinity have no name in JSON.
Json number_or_null(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }

/// What is possible and not probable.
std::vector<std::string> warnings_on(const SlideOptions& o, const Motion& motion, double pga_g) {
  std::vector<std::string> warnings = improbable_values(motion, o.of_roof);
  if ((o.scale || o.pga_g) && pga_g > most_probable_pga_g)
    warnings.push_back(
        fmt::format("a {} of {:.3g} g, with its factor, is above {:g} g: no recorded motion has it",
                    peak_names(o.of_roof).acceleration, pga_g, most_probable_pga_g));
  std::vector<std::string> texts{improbable_friction("a friction", o.c.friction)};
  for (const Parameter& p : parameters()) texts.push_back(improbable_value(p, value_of(p, o.c)));
  for (std::string& text : texts)
    if (!text.empty()) warnings.push_back(std::move(text));
  PeriodsByAxis periods;
  periods.take(o.c);
  std::ranges::move(improbable_building(o.building, periods, o.two_axes()),
                    std::back_inserter(warnings));
  if (o.building.is_one_mass())
    if (std::string text = one_mass_sentence(std::nullopt, o.c.period_s); !text.empty())
      warnings.push_back(text + ": give --alpha, --storeys or --modes");
  return warnings;
}

Json components_json(const std::vector<ReadComponent>& components) {
  Json json = Json::array();
  for (const auto& [name, file, record] : components) {
    const auto& [of_file, dt_s, a, source, read_notes] = record;
    json.push_back({{"component", name},
                    {"samples", a.size()},
                    {"dt_s", dt_s},
                    {"pga_g", peak_ground_acceleration_mps2(a) / standard_gravity_mps2},
                    {"pgv_mps", peak_ground_velocity_mps(dt_s, a)},
                    {"pgd_m", peak_ground_displacement_m(dt_s, a)},
                    {"duration_s", significant_duration_s(dt_s, a)}});
  }
  return json;
}

/// What is printed as a table, and is in JSON.
std::vector<Finding> findings_of(const SlideHistory& h, bool two_axes) {
  const auto length = [](const char* key, const char* label, double value) {
    return Finding{key, label, value, {}, "m"};
  };
  const SlipResult& r = h.slip;
  std::vector<Finding> all{length("peak_displacement_m", "peak", r.peak_displacement_m)};
  if (two_axes) {
    for (const Finding& f :
         {length("peak_x_m", "largest along the slope", r.peak_by_axis.along_m),
          length("peak_y_m", "largest across the slope", r.peak_by_axis.across_m),
          length("srss_m", "SRSS of these two", srss_of_maxima_m(r)),
          length("peak_vector_m", "", r.peak_displacement_m),
          length("residual_x_m", "residual along the slope", r.residual.along_m),
          length("residual_y_m", "residual across the slope", r.residual.across_m),
          length("path_length_m", "path", r.path_length_m)})
      all.push_back(f);
  }
  const char* residual = two_axes ? "" : "residual";
  const double residual_m =
      two_axes ? std::hypot(r.residual.along_m, r.residual.across_m) : r.residual.along_m;
  for (const Finding& f : {length("residual_displacement_m", residual, residual_m),
                           length("peak_downslope_m", "downslope", r.peak_downslope_m),
                           length("peak_upslope_m", "upslope", r.peak_upslope_m)})
    all.push_back(f);
  all.push_back({"peak_velocity_mps", "velocity", r.peak_velocity_mps, {}, "m/s"});
  all.push_back({"slip_duration_s", "slides", r.slip_duration_s, {}, "s"});
  return all;
}

Json to_json(const SlideOptions& o, const SlideHistory& h, const ReadMotion& read, double factor,
             double pga_g) {
  const Motion& motion = read.motion;
  Json json = cli::to_json(findings_of(h, o.two_axes()));
  json.update({{"slip_phases", h.slip.slip_phases},
               {"uplift", h.slip.uplift},
               {"free_sliding", h.slip.free_sliding},
               {"samples", motion.horizontal_mps2[0].size()},
               {"dt_s", motion.dt_s},
               {"pga_g", pga_g},
               {"scale", factor},
               {"mu", o.c.friction},
               {"slope_deg", o.c.slope_deg},
               {"period_s", o.c.period_s},
               {"damping", o.c.damping},
               {"vertical", !motion.vertical_mps2.empty()},
               {"method", o.method}});
  if (o.building.kind == BuildingModel::Kind::cantilever) json["alpha"] = o.c.alpha;
  if (h.ppa_g) json["ppa_g"] = *h.ppa_g;
  if (o.two_axes()) {
    json["mu_across"] = o.c.friction_across;
    json["azimuth_deg"] = o.c.azimuth_deg;
  }
  if (!h.peak_base_shear.empty()) {
    json["mass_ratio"] = o.c.mass_ratio;
    json["peak_base_shear"] = h.peak_base_shear;
    json["peak_roof_displacement_m"] = h.peak_roof_displacement_m;
  }
  if (h.crossing) {
    json["clearance_m"] = *o.clearance_m;
    json["crossing_time_s"] = number_or_null(h.crossing->time_s);
    json["crossing_speed_mps"] = number_or_null(h.crossing->speed_mps);
  }
  if (h.tips_at) {
    json["tips"] = factor > *h.tips_at;
    json["tipping_scale"] = number_or_null(*h.tips_at);
  }
  json["model"] = model_of(o);
  json["as_recorded"] = components_json(read.components);
  json["warnings"] = warnings_on(o, motion, pga_g);
  json["notes"] = notes_on(motion);
  return json;
}

std::string tipping_text(const SlideOptions& o, double tipping_scale, double scale, double pga_g) {
  const double most = rocking_block({}, {*o.cm_height_m, *o.base_width_m}).friction.along;
  if (o.c.friction <= most) {
    return fmt::format(
        "  cannot tip: friction lets it slide first (mu <= width / (2 height) = {:.4g})", most);
  }
  if (!std::isfinite(tipping_scale)) return "  tips       at no scale";
  const std::string onset =
      fmt::format("a scale of {:.4g} (PGA {:.4g} g)", tipping_scale, pga_g / scale * tipping_scale);
  if (scale <= tipping_scale) return "  tips       not before " + onset;
  return "TIPPING: from " + onset +
         " on the body rocks on its base; the model is not valid for this history.";
}

void print_building(const SlideHistory& h) {
  const bool two = h.peak_base_shear.size() == 2;
  const char* axes[] = {two ? " along its first axis" : "", " along its second axis"};
  for (std::size_t i = 0; i < h.peak_base_shear.size(); ++i) {
    put("  building {:.4f} of its weight in base shear, roof {:.4f} m{}\n", h.peak_base_shear[i],
        h.peak_roof_displacement_m[i], axes[i]);
  }
}

/// In lines of the terminal.
void print_sentence(const std::string& text) {
  put("{}\n", text.size() <= terminal_width ? text : wrapped(text, terminal_width, 2));
}

/// What was read: the user sees whether step and units are as they should be.
void print_record(const SlideOptions& o, const ReadMotion& read, double pga_g) {
  for (const auto& [name, file, record] : read.components) {
    const auto& [of_file, dt_s, a, source, read_notes] = record;
    const char* peaks = o.of_roof ? "peaks of the roof" : "peaks";
    put("{}\n  {}, {:g} s; {} {:.3g} g, {:.3g} m/s, {:.3g} m; D5-95 {:.3g} s\n", file,
        counted(a.size(), "sample"), dt_s, peaks,
        peak_ground_acceleration_mps2(a) / standard_gravity_mps2, peak_ground_velocity_mps(dt_s, a),
        peak_ground_displacement_m(dt_s, a), significant_duration_s(dt_s, a));
  }
  for (const std::string& warning : warnings_on(o, read.motion, pga_g))
    print_sentence("WARNING: " + warning);
  for (const std::string& note : notes_on(read.motion)) print_sentence("note  " + note);
}

void print_text(const SlideOptions& o, const SlideHistory& h, const ReadMotion& read, double factor,
                double pga_g) {
  const SlipResult& r = h.slip;
  print_record(o, read, pga_g);
  put("Factor {:.4g}: {} {:.4g} g{}\n", factor, o.of_roof ? "peak roof acceleration" : "PGA", pga_g,
      h.ppa_g && !o.of_roof ? fmt::format(", peak roof acceleration {:.4g} g", *h.ppa_g) : "");
  put("Model: {}\n", model_of(o));
  put("{}", to_text(to_table("Displacement relative to the roof, in plan (downslope "
                             "positive; flat roof: +x)",
                             findings_of(h, o.two_axes()))));
  put("  slides in {}\n", counted(r.slip_phases, "phase"));
  print_building(h);
  if (h.crossing) {
    if (h.crossing->happens()) {
      put("  reaches {:.4f} m after {:.4f} s, with {:.4f} m/s\n", *o.clearance_m,
          h.crossing->time_s, h.crossing->speed_mps);
    } else {
      put("  does not reach {:g} m\n", *o.clearance_m);
    }
  }
  if (h.tips_at) print_sentence(tipping_text(o, *h.tips_at, factor, pga_g));
  if (r.uplift)
    print_sentence(
        "UPLIFT: the normal force falls below zero; the model is not valid for this history.");
  if (r.free_sliding)
    print_sentence(
        "FREE SLIDING: friction cannot stop the block (tan(slope) >= mu); displacements are those "
        "at the record's end.");
}

void run(SlideOptions& o) {
  std::optional<ReadMotion> of_suite;
  if (names_motion(o)) of_suite = motion_of_suite(o);
  check(o);
  const ReadMotion read = of_suite ? *std::move(of_suite) : read_motion(o);
  const Motion& motion = read.motion;
  check_step(o, motion.dt_s);
  const double pga = peak_ground_acceleration_mps2(motion.horizontal_mps2[0]);
  if (o.pga_g && pga == 0.0)
    throw InputError(
        {o.record, "is zero throughout and cannot be scaled to --pga-g", "give --scale", ""});
  const double factor =
      o.pga_g ? *o.pga_g * standard_gravity_mps2 / pga : motion.scale * o.scale.value_or(1.0);
  if (!(factor <= largest_acceleration))
    throw InputError({o.record, fmt::format("the factor {:g} on the motion is too large", factor),
                      "give a smaller --scale or --pga-g", ""});
  const SlideHistory history = run_history(o, motion, factor);
  const double pga_g = factor * pga / standard_gravity_mps2;
  if (o.json) {
    put_json(to_json(o, history, read, factor, pga_g));
  } else {
    print_text(o, history, read, factor, pga_g);
  }
}

}  // namespace

void add_slide(CLI::App& program) {
  auto o = std::make_shared<SlideOptions>();
  CLI::App* command = program.add_subcommand("slide", "How far a block slides on one record");
  add_options(*command, *o);
  command->callback([o] { run(*o); });
}

}  // namespace glissade::cli
