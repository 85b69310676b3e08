// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal/frame.hpp"

#include <algorithm>

#include "glissade/core/bytes.hpp"
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
    : in_(file), most_bytes_(most_bytes), left_(in_.size()) {
  from = std::min(from, left_);
  in_.seek(from);
  left_ -= from;
}

/// As many bytes; false where the file ends before.
bool FrameReader::take(std::span<char> bytes) {
  while (!bytes.empty()) {
    const std::size_t count = in_.read(bytes);
    if (count == 0) return false;
    bytes = bytes.subspan(count);
  }
  return true;
}

std::optional<std::vector<char>> FrameReader::next() {
  std::vector<char> head(frame_head_bytes), content;
  while (left_ >= head.size() && take(head)) {
    std::uint64_t size = 0, check = 0;
    ByteReader(head).get(size).get(check);
    if (size > most_bytes_ || size > left_ - frame_head_bytes) return std::nullopt;
    content.resize(size);
    if (!take(content)) return std::nullopt;
    left_ -= frame_head_bytes + size;
    if (checksum(content) == check) return content;
    damaged_ += frame_head_bytes + size;
  }
  return std::nullopt;
}

}  // namespace glissade
