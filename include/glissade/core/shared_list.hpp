// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <initializer_list>
#include <memory>
#include <span>
#include <stdexcept>
#include <vector>

namespace glissade {

/// Values to read only. Copies share them; those of `elsewhere` belong to somebody else (the ranks
/// of one machine share the motions of a study and the lists of its plan), who must outlive all
/// copies.
template <class T>
class SharedList {
 public:
  using value_type = T;
  using const_iterator = typename std::span<const T>::iterator;
  SharedList() = default;
  SharedList(std::vector<T> values)
      : own_(std::make_shared<const std::vector<T>>(std::move(values))), values_(*own_) {}
  SharedList(std::initializer_list<T> values) : SharedList(std::vector<T>(values)) {}
  static SharedList elsewhere(std::span<const T> values) {
    SharedList list;
    list.values_ = values;
    return list;
  }

  std::size_t size() const { return values_.size(); }
  bool empty() const { return values_.empty(); }
  const T* data() const { return values_.data(); }
  const_iterator begin() const { return values_.begin(); }
  const_iterator end() const { return values_.end(); }
  std::vector<T> copy() const { return {begin(), end()}; }
  const T& front() const { return values_.front(); }
  const T& back() const { return values_.back(); }
  const T& operator[](std::size_t i) const { return values_[i]; }
  /// Throws std::out_of_range.
  const T& at(std::size_t i) const {
    if (i >= size()) throw std::out_of_range("SharedList::at");
    return values_[i];
  }
  friend bool operator==(const SharedList& one, const SharedList& other) {
    return std::ranges::equal(one.values_, other.values_);
  }

 private:
  std::shared_ptr<const std::vector<T>> own_;
  std::span<const T> values_;
};

/// Equally spaced samples.
using Samples = SharedList<double>;

}  // namespace glissade
