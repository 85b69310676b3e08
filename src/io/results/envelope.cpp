// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/envelope.hpp"

#include <new>

#include "glissade/core/error.hpp"
#include "glissade/core/file.hpp"

namespace glissade {
namespace {

std::string file_type_of(const Hdf5Reader& root) {
  std::string file_type;
  root.attribute("file_type", file_type);
  return file_type;
}

void check_type_and_version(const ResultsKind& kind, const Hdf5Reader& root) {
  const std::string file_type = file_type_of(root);
  if (file_type != kind.file_type) throw Hdf5Error("take the file type " + file_type);
  std::uint64_t version = 0;
  root.attribute("format_version", version);
  if (version != static_cast<std::uint64_t>(kind.format_version)) {
    throw Hdf5Error("understand format version " + std::to_string(version) +
                    " (this program reads " + std::to_string(kind.format_version) + ")");
  }
}

}  // namespace

void write_results_of(const ResultsKind& kind, const std::filesystem::path& file,
                      const std::function<void(const Hdf5Writer&)>& content) {
  const Hdf5Silence silence;
  std::string bytes;
  try {
    const Hdf5Image image;
    {
      const Hdf5Writer root(image);
      root.attribute("file_type", std::string(kind.file_type));
      root.attribute("format_version", static_cast<std::uint64_t>(kind.format_version));
      content(root);
    }
    bytes = image.bytes();
  } catch (const Hdf5Error& error) {
    throw InputError({file.string(),
                      std::string("the results could not be put together: cannot ") + error.what(),
                      "check that there is memory enough, or take fewer samples, levels or records",
                      ""});
  }
  write_text_file(file, bytes);
}

void read_results_of(const ResultsKind& kind, const std::filesystem::path& file,
                     const std::function<void(const Hdf5Reader&)>& content) {
  const Hdf5Silence silence;
  const auto fail = [&](const std::string& reason) {
    return InputError({file.string(),
                       std::string("is not a complete ") + kind.name + ": cannot " + reason,
                       "give a results file of `glissade run`, or run the study again", ""});
  };
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored))
    throw InputError({file.string(), "no such file", "check the path", ""});
  if (!std::filesystem::is_regular_file(file, ignored)) throw fail("read what is no ordinary file");
  try {
    const Hdf5Reader root(file);
    check_type_and_version(kind, root);
    content(root);
  } catch (const Hdf5Error& error) {
    throw fail(error.what());
  } catch (const std::bad_alloc&) {
    throw fail("hold it in memory");
  }
}

bool is_results_of(const ResultsKind& kind, const std::filesystem::path& file) {
  const Hdf5Silence silence;
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) return false;
  try {
    return file_type_of(Hdf5Reader(file)) == kind.file_type;
  } catch (const Hdf5Error&) {
    return false;
  }
}

}  // namespace glissade
