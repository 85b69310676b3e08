// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal/frame.hpp"

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "glissade/core/bytes.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/hash.hpp"

namespace glissade {
namespace {

std::uint64_t checksum(std::span<const char> content) {
  return Hasher().number(std::uint64_t{content.size()}).bytes(std::as_bytes(content)).value();
}

}  // namespace

std::string framed(std::span<const char> content) {
  const std::vector<char> head =
      ByteWriter().put(std::uint64_t{content.size()}).put(checksum(content)).take();
  std::string frame(head.begin(), head.end());
  return frame.append(content.data(), content.size());
}

FrameReader::FrameReader(const std::filesystem::path& file, std::uint64_t most_bytes,
                         std::uint64_t from)
    : in_(file, std::ios::binary), most_bytes_(most_bytes) {
  std::error_code error;
  left_ = std::filesystem::file_size(file, error);
  if (error || !in_) {
    const int reason = error ? error.value() : errno;
    throw InputError({file.string(), "cannot be read: " + std::generic_category().message(reason),
                      "check that you may read it", ""});
  }
  from = std::min(from, left_);
  in_.seekg(static_cast<std::streamoff>(from));
  left_ -= from;
}

std::optional<std::vector<char>> FrameReader::next() {
  std::vector<char> head(frame_head_bytes), content;
  while (left_ >= head.size() && in_.read(head.data(), frame_head_bytes)) {
    std::uint64_t size = 0, check = 0;
    ByteReader(head).get(size).get(check);
    if (size > most_bytes_ || size > left_ - frame_head_bytes) return std::nullopt;
    content.resize(size);
    if (!in_.read(content.data(), static_cast<std::streamsize>(size))) return std::nullopt;
    left_ -= frame_head_bytes + size;
    if (checksum(content) == check) return content;
    damaged_ += frame_head_bytes + size;
  }
  return std::nullopt;
}

}  // namespace glissade
