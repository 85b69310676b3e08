// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "glissade/io/record_file.hpp"
#include "glissade/io/suite_import.hpp"

namespace glissade {

/// By the bytes it begins with: zip, tar, or what gzip packed.
bool is_archive(std::string_view bytes);

struct PackedFile {
  std::string name;  ///< its path in the archive, which leads to no place outside; an archive in
                     ///< the archive is a folder: "a.zip/b.V2"
  std::string bytes;
};
/// Gives the files of an archive, and of archives in it, one after the other, in memory only,
/// without folders and hidden ones; what is left out: links, encrypted files, improper names.
/// Throws InputError where it is damaged, and where it holds more than 20,000 files, 256 MiB in one
/// or 512 MiB in all.
std::vector<LeftOut> unpack(const std::filesystem::path& file, std::string_view bytes,
                            const std::function<void(PackedFile)>& take);

/// The bytes of record files; those of the file or archive that was read last are kept, so that
/// what several components are in is read once.
class RecordStore {
 public:
  struct Found {
    std::filesystem::path path;  ///< for messages: records.zip#a.AT2
    const std::string* bytes;    ///< until the next call
    std::string component;       ///< of that file; may be empty
  };
  /// @param inside what stands behind the file: a component, or of an archive a member and behind
  /// another # its component; an archive of one file needs no member. Throws InputError where there
  /// is no such member.
  Found find(const std::filesystem::path& file, const std::string& inside);

 private:
  std::filesystem::path last_;
  bool is_packed_ = false;
  std::string bytes_;
  std::vector<PackedFile> files_;
};

/// read_record() of a component that was found.
Record read_record(const RecordStore::Found& found, RecordFileOptions options);

}  // namespace glissade
