// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "enum_names.hpp"
#include "results/archive.hpp"

// What several analyses have in the results file.
namespace glissade {

/// How datasets of intensities are named, and their unit.
struct IntensityScale {
  const char* unit;
  std::string suffix;  ///< "_g"
  std::string level = "level" + suffix;
};

/// A choice as an attribute.
template <class E, class Archive, class Value>
void name_attribute(const Archive& archive, const std::string& name, EnumNames<E> names,
                    Value& value) {
  std::string text;
  if constexpr (!Archive::reads) text = name_of<E>(names, value);
  archive.attribute(name, text);
  if constexpr (Archive::reads) value = value_of<E>(names, text);
}

/// What standards prescribe.
template <class Archive, class Prescriptions>
void exchange_prescriptions(const Archive& archive, Prescriptions& rows) {
  using Row = typename Prescriptions::value_type;
  const Columns column(archive, rows, "standard");
  column("standard", {"-", "standard"}, &Row::standard, standard_names());
  column("sds_g", {"g", "design spectral acceleration S_DS"}, &Row::sds_g);
  column("prescribed_m", {"m", "prescribed displacement"},
         member(&Row::prescribed, &Prescription::value_m));
  column("provenance", {"-", "how well the provision is known"},
         member(&Row::prescribed, &Prescription::provenance), provenance_names());
  column("basis", {"-", "equation or clause"}, member(&Row::prescribed, &Prescription::basis));
}

}  // namespace glissade
