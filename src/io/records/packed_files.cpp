// SPDX-License-Identifier: GPL-3.0-or-later
#include "records/packed_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <set>

#include "glissade/core/error.hpp"
#include "glissade/core/file.hpp"
#include "glissade/core/printable.hpp"

#ifdef GLISSADE_ARCHIVES
#include <archive.h>
#include <archive_entry.h>
#endif

namespace glissade {

namespace fs = std::filesystem;

bool is_archive(std::string_view bytes) {
  using namespace std::string_view_literals;
  constexpr std::size_t tar_mark = 257;
  return bytes.starts_with("PK\x03\x04"sv) || bytes.starts_with("PK\x05\x06"sv) ||
         bytes.starts_with("\x1f\x8b\x08"sv) ||
         (bytes.size() > tar_mark && bytes.substr(tar_mark).starts_with("ustar"sv));
}

#ifdef GLISSADE_ARCHIVES
namespace {

constexpr std::size_t most_files = 20'000, most_bytes = std::size_t{256} << 20,
                      most_bytes_in_all = std::size_t{512} << 20;

[[noreturn]] void refuse(const fs::path& file, const std::string& what, const char* remedy) {
  throw InputError({file.string(), what, remedy, ""});
}

struct ArchiveCloser {
  void operator()(archive* a) const { archive_read_free(a); }
};
using OpenArchive = std::unique_ptr<archive, ArchiveCloser>;

[[noreturn]] void refuse_damaged(const fs::path& file, archive* a) {
  const char* reason = archive_error_string(a);
  refuse(file,
         fmt::format("cannot be unpacked: {}",
                     reason == nullptr ? "it is damaged" : printable_name(reason)),
         "get it again, or unpack it and name the folder");
}

OpenArchive open(const fs::path& file, std::string_view bytes) {
  OpenArchive a(archive_read_new());
  if (!a) throw std::bad_alloc();
  archive_read_support_filter_gzip(a.get());
  archive_read_support_format_zip(a.get());
  archive_read_support_format_tar(a.get());
  archive_read_support_format_raw(a.get());  // one file that gzip packed
  if (archive_read_open_memory(a.get(), bytes.data(), bytes.size()) != ARCHIVE_OK)
    refuse_damaged(file, a.get());
  return a;
}

/// Why a member is no file to be read; "" where it is one.
std::string reason_against(archive_entry* entry, const std::string& name) {
  if (archive_entry_hardlink(entry) != nullptr || archive_entry_filetype(entry) != AE_IFREG)
    return "is a link or a device, and no file";
  if (archive_entry_is_encrypted(entry) != 0) return "is encrypted: unpack it with its password";
  if (name.empty() || printable_name(name) != name)
    return "its name has control characters or is no UTF-8: rename it";
  const fs::path path(name);
  if (path.is_absolute() || std::ranges::find(path, fs::path("..")) != path.end())
    return "its path leads out of the archive";
  return "";
}

bool is_hidden(const std::string& name) {
  return std::ranges::any_of(fs::path(name), [](const fs::path& part) {
    return part == "__MACOSX" || (part.string().starts_with('.') && part != "." && part != "..");
  });
}

std::string data_of(const fs::path& file, archive* a, std::size_t room) {
  std::array<char, 65536> block;
  std::string bytes;
  for (;;) {
    const la_ssize_t count = archive_read_data(a, block.data(), block.size());
    if (count < 0) refuse_damaged(file, a);
    if (count == 0) return bytes;
    bytes.append(block.data(), static_cast<std::size_t>(count));
    if (bytes.size() > std::min(room, most_bytes))
      refuse(file,
             fmt::format("holds more than {} MiB in one file, or {} MiB in all", most_bytes >> 20,
                         most_bytes_in_all >> 20),
             "unpack it and name the folder");
  }
}

}  // namespace

namespace {

/// What is in an archive, and in archives in it.
class Unpacker {
 public:
  Unpacker(const fs::path& file, const std::function<void(PackedFile)>& take)
      : file_(file), take_(take) {}

  /// @param above names of the archive's files begin with it: "" or "a.zip/"
  void add(std::string_view bytes, const std::string& above) {
    const fs::path shown = above.empty() ? file_ : fs::path(file_.string() + "#" + above);
    const OpenArchive a = open(shown, bytes);
    for (archive_entry* entry = nullptr;;) {
      const int result = archive_read_next_header(a.get(), &entry);
      if (result == ARCHIVE_EOF) return;
      if (result != ARCHIVE_OK && result != ARCHIVE_WARN) refuse_damaged(shown, a.get());
      if (++count_ > most_files)
        refuse(file_, fmt::format("holds more than {} files", most_files),
               "unpack it and name the folder with the records");
      const char* stated = archive_entry_pathname(entry);
      std::string name = stated == nullptr ? "" : stated;
      if (archive_format(a.get()) == ARCHIVE_FORMAT_RAW)
        name = (above.empty() ? file_ : fs::path(above).parent_path()).stem().string();
      if (archive_entry_filetype(entry) == AE_IFDIR || is_hidden(name)) continue;
      const std::string reason = reason_against(entry, name);
      if (reason.empty())
        take(above + name, data_of(shown, a.get(), room_), above.empty());
      else
        leave_out(above + printable_name(name), reason);
    }
  }
  std::vector<LeftOut> left_out() { return std::move(left_out_); }

 private:
  void take(const std::string& name, std::string bytes, bool may_be_archive) {
    room_ -= bytes.size();
    if (is_archive(bytes) && may_be_archive) return add(bytes, name + "/");
    if (is_archive(bytes))
      return leave_out(name, "is an archive in an archive of archives: unpack it");
    if (!names_.insert(name).second)
      return leave_out(name, "a second file of this name in the archive");
    take_({name, std::move(bytes)});
  }
  void leave_out(const std::string& name, const std::string& reason) {
    left_out_.push_back({file_.string() + "#" + name, reason});
  }

  fs::path file_;
  const std::function<void(PackedFile)>& take_;
  std::vector<LeftOut> left_out_;
  std::set<std::string> names_;
  std::size_t room_ = most_bytes_in_all, count_ = 0;
};

}  // namespace

std::vector<LeftOut> unpack(const fs::path& file, std::string_view bytes,
                            const std::function<void(PackedFile)>& take) {
  Unpacker unpacker(file, take);
  unpacker.add(bytes, "");
  return unpacker.left_out();
}

#else

std::vector<LeftOut> unpack(const fs::path& file, std::string_view,
                            const std::function<void(PackedFile)>&) {
  throw InputError({file.string(), "is an archive, and this program was built without libarchive",
                    "install libarchive-dev and build again, or unpack it", ""});
}

#endif

RecordStore::Found RecordStore::find(const fs::path& file, const std::string& inside) {
  if (last_ != file) {
    last_.clear();
    files_.clear();
    bytes_ = read_text_file(file);
    is_packed_ = is_archive(bytes_);
    if (is_packed_) {
      unpack(file, bytes_, [&](PackedFile packed) { files_.push_back(std::move(packed)); });
      bytes_.clear();
    }
    last_ = file;
  }
  if (!is_packed_) return {file, &bytes_, inside};
  const auto found_as = [&](const PackedFile& packed, const std::string& component) -> Found {
    return {file.string() + "#" + packed.name, &packed.bytes, component};
  };
  for (std::size_t end = inside.size(); end != std::string::npos && !inside.empty();
       end = end == 0 ? std::string::npos : inside.rfind('#', end - 1)) {
    const auto member = std::ranges::find(files_, inside.substr(0, end), &PackedFile::name);
    if (member != files_.end())
      return found_as(*member, inside.substr(std::min(end + 1, inside.size())));
  }
  if (files_.size() == 1) return found_as(files_.front(), inside);
  constexpr std::size_t most_listed = 20;
  std::string list;
  for (std::size_t i = 0; i < std::min(most_listed, files_.size()); ++i)
    list += (i == 0 ? "" : ", ") + files_[i].name;
  if (files_.size() > most_listed) list += " ...";
  throw InputError({file.string(),
                    inside.empty() ? fmt::format("is an archive of {} files", files_.size())
                                   : fmt::format("holds no file {}", printable_name(inside)),
                    "name one behind it: " + file.filename().string() + "#FILE", list});
}

}  // namespace glissade
