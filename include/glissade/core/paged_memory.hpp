// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <limits>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>

namespace glissade {

/// Pages of a file without a name in `folder`, all zero: the system writes them there where memory
/// is short, so what they hold may be larger than the memory. Its disk space is taken at once. The
/// file is gone when they are given back, or with the process. Throws InputError where there is no
/// room.
void* map_pages(const std::filesystem::path& folder, std::size_t bytes);
void unmap_pages(void* pages, std::size_t bytes);

/// Of a std::vector that may be larger than the memory: from `least_bytes` on its values are in
/// pages of a file in a folder. Without a folder, and of a copy, it is as any other.
template <class T>
class PagedAllocator {
 public:
  using value_type = T;
  using propagate_on_container_move_assignment = std::true_type;
  using propagate_on_container_swap = std::true_type;
  static constexpr std::size_t least_bytes = std::size_t{1} << 24;

  PagedAllocator() = default;
  explicit PagedAllocator(const std::filesystem::path& folder)
      : folder_(std::make_shared<const std::filesystem::path>(folder)) {}
  template <class U>
  explicit PagedAllocator(const PagedAllocator<U>& other) : folder_(other.folder()) {}

  T* allocate(std::size_t count) {
    if (count > std::numeric_limits<std::size_t>::max() / sizeof(T))
      throw std::bad_array_new_length();
    return static_cast<T*>(is_paged(count) ? map_pages(*folder_, count * sizeof(T))
                                           : ::operator new(count * sizeof(T)));
  }
  void deallocate(T* values, std::size_t count) {
    if (is_paged(count)) return unmap_pages(values, count * sizeof(T));
    ::operator delete(values);
  }
  PagedAllocator select_on_container_copy_construction() const { return {}; }
  bool operator==(const PagedAllocator& other) const { return folder_ == other.folder_; }
  const std::shared_ptr<const std::filesystem::path>& folder() const { return folder_; }

 private:
  bool is_paged(std::size_t count) const {
    return folder_ != nullptr && count >= least_bytes / sizeof(T);
  }
  std::shared_ptr<const std::filesystem::path> folder_;
};

}  // namespace glissade
