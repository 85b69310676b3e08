// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace glissade {

/// FNV-1a, 64 bits (Fowler, Noll & Vo 1991): names a plan by its content. Not cryptographic.
class Hasher {
 public:
  Hasher& bytes(std::span<const std::byte> data);
  Hasher& text(std::string_view text);  ///< length, then characters
  Hasher& number(double value);         ///< its bits
  Hasher& number(std::uint64_t value);
  Hasher& numbers(std::span<const double> values);
  std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 0xcbf29ce484222325u;
};

std::string to_hex(std::uint64_t value);  ///< 16 lower-case digits

}  // namespace glissade
