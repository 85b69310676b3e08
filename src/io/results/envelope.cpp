// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/envelope.hpp"

#include <algorithm>
#include <new>
#include <span>
#include <string_view>

#include "glissade/core/error.hpp"
#include "glissade/core/file.hpp"
#include "glissade/core/hash.hpp"
#include "glissade/core/input_file.hpp"

namespace glissade {
namespace {

/// The end of a results file. HDF5 knows where its own data end; programs that change them cut the
/// rest off.
constexpr std::string_view checksum_key = "\nglissade checksum ";
constexpr std::size_t checksum_bytes = checksum_key.size() + 17;

/// Of the next `size` bytes of a file.
std::string checksum_line(const InputFile& file, std::uintmax_t size) {
  Hasher hasher;
  std::string block(std::size_t{1} << 20, '\0');
  while (size > 0) {
    const std::size_t part =
        file.read(std::span(block).first(std::min<std::uintmax_t>(size, block.size())));
    if (part == 0) return "";  // the file has become shorter
    hasher.bytes(std::as_bytes(std::span(block.data(), part)));
    size -= part;
  }
  return std::string(checksum_key) + to_hex(hasher.value()) + '\n';
}

/// Before libhdf5 opens a file: it does not stand every damage. What is wrong; empty: nothing.
std::string checksum_fault(const std::filesystem::path& path) {
  const InputFile file(path);
  const std::uintmax_t size = file.size();
  const std::uintmax_t of_content = size - std::min<std::uintmax_t>(size, checksum_bytes);
  file.seek(of_content);
  std::string line(checksum_bytes, '\0');
  line.resize(file.read(line));
  if (!line.starts_with(checksum_key))
    return "it does not end with a checksum (cut short, changed by another program, or of another "
           "version)";
  file.seek(0);
  if (line != checksum_line(file, of_content))
    return "it is damaged: its content does not have its checksum";
  return "";
}

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

namespace {

void write_hdf5(OutputFile& output, const std::function<void(const Hdf5Writer&)>& content) {
  Hdf5OutputFile file(output);
  try {
    content(Hdf5Writer(file));
    file.close();
  } catch (const Hdf5Error&) {
    file.throw_failure();  // which was the cause
    throw;
  }
}

/// What is on the disk is read again, where the system lets it be, and compared.
void read_back(const std::filesystem::path& file, OutputFile& output,
               const std::function<void(const Hdf5Writer&)>& content) {
  output.sync();
  output.forget();
  if (!checksum_fault(file).empty()) throw Hdf5Error("find the checksum of what was written");
  content(Hdf5Writer::comparing(file));
}

}  // namespace

void write_results_of(const ResultsKind& kind, const std::filesystem::path& file,
                      const std::function<void(const Hdf5Writer&)>& content) {
  const Hdf5Silence silence;
  const auto whole_content = [&](const Hdf5Writer& root) {
    root.attribute("file_type", std::string(kind.file_type));
    root.attribute("format_version", static_cast<std::uint64_t>(kind.format_version));
    content(root);
  };
  write_file(file, [&](OutputFile& output, const std::filesystem::path& partial) {
    try {
      write_hdf5(output, whole_content);
      append_checksum(partial, output);
      read_back(partial, output, whole_content);
    } catch (const Hdf5Error& error) {
      throw InputError({file.string(), std::string("cannot be written: cannot ") + error.what(),
                        "check the disk, and that there are memory and space enough", ""});
    }
  });
}

void append_checksum(const std::filesystem::path& path, OutputFile& output) {
  const InputFile file(path);
  const std::uintmax_t size = file.size();
  output.write_at(size, checksum_line(file, size));
}

void read_results_of(const ResultsKind& kind, const std::filesystem::path& file,
                     const std::function<void(const Hdf5Reader&)>& content) {
  const Hdf5Silence silence;
  const auto fail = [&](const std::string& reason) {
    return InputError({file.string(), std::string("is not a complete ") + kind.name + ": " + reason,
                       "give a results file of `glissade run`, or run the study again", ""});
  };
  const std::filesystem::file_status status = status_of(file);
  if (!std::filesystem::exists(status))
    throw InputError({file.string(), "no such file", "check the path", ""});
  if (!std::filesystem::is_regular_file(status)) throw fail("it is no regular file");
  const std::string fault = checksum_fault(file);
  if (!fault.empty()) throw fail(fault);
  try {
    const Hdf5Reader root(file);
    check_type_and_version(kind, root);
    content(root);
  } catch (const Hdf5Error& error) {
    throw fail(std::string("cannot ") + error.what());
  } catch (const std::bad_alloc&) {
    throw fail("cannot hold it in memory");
  }
}

}  // namespace glissade
