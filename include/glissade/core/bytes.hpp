// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace glissade {

/// Packs values for another process of the same run, or for its journal (same machine type, same
/// program).
class ByteWriter {
 public:
  template <class T>
  requires std::is_trivially_copyable_v<T> ByteWriter& put(const T& value) {
    const auto* first = reinterpret_cast<const char*>(&value);
    bytes_.insert(bytes_.end(), first, first + sizeof(T));
    return *this;
  }
  template <class T, class Allocator>
  requires std::is_trivially_copyable_v<T> ByteWriter& put(
      const std::vector<T, Allocator>& values) {
    put(values.size());
    const auto* first = reinterpret_cast<const char*>(values.data());
    bytes_.insert(bytes_.end(), first, first + values.size() * sizeof(T));
    return *this;
  }
  ByteWriter& put(const std::string& text) {
    return put(std::vector<char>(text.begin(), text.end()));
  }
  ByteWriter& put(const std::vector<std::string>& texts) {
    put(texts.size());
    for (const std::string& text : texts) put(text);
    return *this;
  }
  std::vector<char> take() { return std::move(bytes_); }

 private:
  std::vector<char> bytes_;
};

/// Bytes that end before what they should contain.
struct ShortMessage : std::logic_error {
  ShortMessage() : std::logic_error("ByteReader: message shorter than its content") {}
};

/// Unpacks; nothing larger than the message itself is allocated.
class ByteReader {
 public:
  explicit ByteReader(std::span<const char> bytes) : bytes_(bytes) {}
  bool at_end() const { return bytes_.empty(); }
  template <class T>
  requires std::is_trivially_copyable_v<T> ByteReader& get(T& value) {
    copy(&value, sizeof(T));
    return *this;
  }
  template <class T, class Allocator>
  requires std::is_trivially_copyable_v<T> ByteReader& get(std::vector<T, Allocator>& values) {
    std::size_t count = 0;
    get(count);
    if (count > bytes_.size() / sizeof(T)) throw ShortMessage();
    values.resize(count);
    copy(values.data(), count * sizeof(T));
    return *this;
  }
  ByteReader& get(std::string& text) {
    std::vector<char> characters;
    get(characters);
    text.assign(characters.begin(), characters.end());
    return *this;
  }
  ByteReader& get(std::vector<std::string>& texts) {
    std::size_t count = 0;
    get(count);
    texts.clear();
    for (std::size_t i = 0; i < count; ++i) get(texts.emplace_back());
    return *this;
  }

 private:
  void copy(void* to, std::size_t size) {
    if (size > bytes_.size()) throw ShortMessage();
    if (size > 0) std::memcpy(to, bytes_.data(), size);
    bytes_ = bytes_.subspan(size);
  }
  std::span<const char> bytes_;
};

}  // namespace glissade
