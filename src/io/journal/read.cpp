// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "glissade/core/bytes.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/input_file.hpp"
#include "glissade/io/journal.hpp"
#include "glissade/study/run/exchange.hpp"
#include "journal/frame.hpp"
#include "journal/names.hpp"

namespace glissade {
namespace {

namespace fs = std::filesystem;

/// No record of a unit is longer.
std::uint64_t most_unit_bytes(const Plan& plan) {
  std::size_t cases = 0;
  for (const WorkUnit& unit : plan.units) cases = std::max(cases, unit.count);
  constexpr double beside_histories = 4096.0;  // counts, and the lengths of the fields
  return static_cast<std::uint64_t>(bytes_of(plan.config, 1, cases) + beside_histories);
}

std::uint64_t read_units(const fs::path& file, const std::string& head, const Plan& plan,
                         std::vector<bool>& done,
                         const std::function<void(const UnitResult&)>& take) {
  FrameReader in(file, std::max<std::uint64_t>(most_unit_bytes(plan), head.size()));
  std::uint64_t not_read = in.bytes_left();
  const auto first = in.next();
  if (!first || in.bytes_damaged() > 0) return not_read;
  if (framed(*first) != head) {
    throw InputError({file.string(), "is the journal of another run",
                      "move it out of the folder, or run the study in another folder", ""});
  }
  not_read -= head.size();
  while (const auto record = in.next()) {
    UnitResult unit;
    try {
      unit = unpack_unit_result(*record);
    } catch (const ShortMessage&) {
      continue;
    }
    if (!fits(plan, unit)) continue;
    not_read -= frame_head_bytes + record->size();
    if (done[unit.unit]) continue;
    done[unit.unit] = true;
    take(unit);
  }
  return not_read;
}

}  // namespace

std::uint64_t read_journals(const fs::path& run_folder, const RunIdentity& run, const Plan& plan,
                            const std::function<void(const UnitResult&)>& take) {
  std::uint64_t bytes_not_read = 0;
  std::vector<bool> done(plan.units.size(), false);
  const std::string head = units_head(run);
  for (const fs::path& file : JournalNames(run_folder).all_units())
    bytes_not_read += read_units(file, head, plan, done, take);
  return bytes_not_read;
}

bool has_units(const fs::path& run_folder) {
  const std::uint64_t head_bytes = units_head({}).size();
  return std::ranges::any_of(JournalNames(run_folder).all_units(), [&](const fs::path& file) {
    return InputFile(file).size() > head_bytes;
  });
}

}  // namespace glissade
