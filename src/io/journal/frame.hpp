// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "glissade/core/input_file.hpp"

namespace glissade {

/// A record of a journal: length, checksum of length and content (8 bytes each), content.
std::string framed(std::span<const char> content);

/// Reads the records of a file up to the last whole one. One whose checksum is wrong is passed
/// over, by its length. IoError where the file cannot be read.
class FrameReader {
 public:
  /// @param most_bytes longer records are not whole
  /// @param from where the first record begins
  FrameReader(const std::filesystem::path& file, std::uint64_t most_bytes, std::uint64_t from = 0);
  /// Nothing: no whole record follows.
  std::optional<std::vector<char>> next();
  std::uint64_t bytes_left() const { return left_; }
  std::uint64_t bytes_damaged() const { return damaged_; }

 private:
  bool take(std::span<char> bytes);
  InputFile in_;
  std::uint64_t most_bytes_, left_, damaged_ = 0;
};

/// The checksum (FNV-1a) finds every change of one byte. It is none against intent.
inline constexpr std::uint64_t frame_head_bytes = 16;

}  // namespace glissade
