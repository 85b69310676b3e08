// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/core/hash.hpp"

#include <bit>

namespace glissade {

Hasher& Hasher::bytes(std::span<const std::byte> data) {
  for (const std::byte byte : data) {
    state_ = (state_ ^ static_cast<std::uint64_t>(byte)) * 0x100000001b3u;
  }
  return *this;
}

Hasher& Hasher::number(std::uint64_t value) {
  for (int shift = 0; shift < 64; shift += 8) {  // byte by byte: the same on any byte order
    state_ = (state_ ^ (value >> shift & 0xffu)) * 0x100000001b3u;
  }
  return *this;
}

Hasher& Hasher::number(double value) { return number(std::bit_cast<std::uint64_t>(value)); }

Hasher& Hasher::numbers(std::span<const double> values) {
  number(std::uint64_t{values.size()});
  for (const double value : values) number(value);
  return *this;
}

Hasher& Hasher::text(std::string_view text) {
  number(std::uint64_t{text.size()});
  return bytes(std::as_bytes(std::span(text.data(), text.size())));
}

std::string to_hex(std::uint64_t value) {
  std::string digits(16, '0');
  for (int i = 15; i >= 0; --i, value >>= 4)
    digits[static_cast<std::size_t>(i)] = "0123456789abcdef"[value & 15u];
  return digits;
}

}  // namespace glissade
