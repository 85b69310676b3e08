// SPDX-License-Identifier: GPL-3.0-or-later
// Journals of a run: the input is a file of units. The first byte says whether it is taken as it
// is, or as the content of records (a byte of length each, in eighths of a number) that get their
// lengths and checksums here, so that the reader of units is reached. Then as the run's identity.
#include <string>

#include "bytes.hpp"
#include "check.hpp"
#include "glissade/core/bytes.hpp"
#include "glissade/core/file.hpp"
#include "glissade/core/hash.hpp"
#include "glissade/study/run/exchange.hpp"
#include "unit/io/journal_plan.hpp"

namespace {

using namespace glissade;
using fuzz::check;

std::string framed(const std::string& content) {
  Hasher hasher;
  hasher.number(std::uint64_t{content.size()})
      .bytes(std::as_bytes(std::span(content.data(), content.size())));
  const auto head = ByteWriter().put(std::uint64_t{content.size()}).put(hasher.value()).take();
  return std::string(head.begin(), head.end()) + content;
}

std::string with_checksums(fuzz::Bytes in) {
  std::string file;
  while (in.left() > 0) {
    std::string content(8 * std::size_t{in.take<std::uint8_t>()}, '\0');
    for (char& c : content) c = in.take<char>();
    file += framed(content);
  }
  return file;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Plan plan = test::journal_plan();
  static const RunIdentity run = identity_of(plan, "1");
  static const std::string head = [] {  // of a file of this run
    std::filesystem::create_directories(fuzz::folder().path() / "journal");
    JournalWriter(fuzz::folder().path(), 0, run).append(test::journal_unit(plan, 0));
    const auto file = fuzz::folder().path() / "journal/0-1.units";
    const std::string bytes = read_text_file(file);
    return bytes.substr(0, bytes.size() - 16 - pack(test::journal_unit(plan, 0)).size());
  }();
  fuzz::Bytes in(data, size);
  const bool as_it_is = in.take<std::uint8_t>() % 2 == 0;
  const std::string rest = as_it_is && size > 0
                               ? std::string(reinterpret_cast<const char*>(data) + 1, size - 1)
                               : with_checksums(in);
  fuzz::write_input("journal/0-1.units", head + rest);
  std::size_t units = 0;
  const auto take = [&](const UnitResult& unit) {
    check(++units <= plan.units.size(), "each unit is read once");
    check(fits(plan, unit), "units fit the plan");
  };
  read_journals(fuzz::folder().path(), run, plan, take);

  fuzz::write_input("journal/0-1.units", rest);  // perhaps of another run
  fuzz::may_refuse([&] {
    units = 0;
    read_journals(fuzz::folder().path(), run, plan, take);
  });
  fuzz::write_input("journal/run", rest);
  fuzz::may_refuse([&] { read_identity(fuzz::folder().path()); });
  return 0;
}
