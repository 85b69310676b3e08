// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <initializer_list>
#include <memory>
#include <span>
#include <vector>

namespace glissade {

/// Equally spaced samples, read only. Copies share them; those of `elsewhere` belong to somebody
/// else (the ranks of one machine share the motions of a study), who must outlive all copies.
class Samples {
 public:
  using value_type = double;
  using const_iterator = std::span<const double>::iterator;
  Samples() = default;
  Samples(std::vector<double> values)
      : own_(std::make_shared<const std::vector<double>>(std::move(values))), values_(*own_) {}
  Samples(std::initializer_list<double> values) : Samples(std::vector<double>(values)) {}
  static Samples elsewhere(std::span<const double> values) {
    Samples samples;
    samples.values_ = values;
    return samples;
  }

  std::size_t size() const { return values_.size(); }
  bool empty() const { return values_.empty(); }
  const double* data() const { return values_.data(); }
  const_iterator begin() const { return values_.begin(); }
  const_iterator end() const { return values_.end(); }
  std::vector<double> copy() const { return {begin(), end()}; }
  double front() const { return values_.front(); }
  double back() const { return values_.back(); }
  double operator[](std::size_t i) const { return values_[i]; }
  friend bool operator==(const Samples& one, const Samples& other) {
    return std::ranges::equal(one.values_, other.values_);
  }

 private:
  std::shared_ptr<const std::vector<double>> own_;
  std::span<const double> values_;
};

}  // namespace glissade
