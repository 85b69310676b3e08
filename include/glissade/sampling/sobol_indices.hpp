// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "glissade/core/independent_units.hpp"

namespace glissade {

/// Of one factor: the group of each sample, by the size of the factor there.
using FactorGroups = std::vector<std::size_t>;

/// By ordered values: equal values together where they are few, else up to 16 groups of equal size,
/// of 8 samples or more.
FactorGroups groups_of(const std::vector<double>& values);

/// A response at every point of a crossed design: all records by the samples of the pick-freeze
/// matrices (Saltelli et al. 2010) A, B and, for each factor, A with that factor from B; or by the
/// samples of one matrix, in groups by each factor (given data), which are independent, or Sobol
/// points in blocks of independent scrambles.
class CrossedResponse {
 public:
  CrossedResponse(std::size_t records, std::size_t factors, std::size_t samples)
      : records_(records), factors_(factors), samples_(samples) {
    values_.resize(records * matrices() * samples);
  }
  /// @param groups of each factor
  /// @param blocks of equal size, one after the other; 1: all samples are independent
  CrossedResponse(std::size_t records, std::vector<FactorGroups> groups, std::size_t blocks)
      : records_(records),
        factors_(groups.size()),
        samples_(groups.front().size()),
        blocks_(blocks),
        groups_(std::move(groups)) {
    values_.resize(records * samples_);
  }
  std::size_t records() const { return records_; }
  /// Records that depend on each other, by their unit, from 0; each is its own unless stated.
  void set_units(std::vector<std::size_t> unit_of) { unit_of_ = std::move(unit_of); }
  std::size_t unit(std::size_t record) const { return unit_at(unit_of_, record); }
  std::size_t units() const { return unit_count(unit_of_, records_); }
  std::size_t factors() const { return factors_; }
  std::size_t samples() const { return samples_; }
  bool is_given_data() const { return !groups_.empty(); }
  std::size_t matrices() const { return is_given_data() ? 1 : factors_ + 2; }
  /// Whose samples are independent.
  std::size_t plain_matrices() const { return is_given_data() ? 1 : 2; }
  std::size_t blocks() const { return blocks_; }
  std::size_t block(std::size_t sample) const { return sample / (samples_ / blocks_); }
  std::size_t group(std::size_t factor, std::size_t sample) const {
    return groups_[factor][sample];
  }
  /// @param matrix 0: A, 1: B, 2 + i: A with factor i from B
  double& operator()(std::size_t record, std::size_t matrix, std::size_t sample) {
    return values_[(record * matrices() + matrix) * samples_ + sample];
  }
  double operator()(std::size_t record, std::size_t matrix, std::size_t sample) const {
    return values_[(record * matrices() + matrix) * samples_ + sample];
  }

 private:
  std::size_t records_, factors_, samples_, blocks_ = 1;
  std::vector<FactorGroups> groups_;
  std::vector<std::size_t> unit_of_;
  std::vector<double> values_;
};

/// A share of the variance and its 95 % interval, which is within 0 and 1. The estimate of a small
/// share may be below 0.
struct VarianceShare {
  double value = 0.0, low = 0.0, high = 0.0;
};

/// first: the part of the variance that goes if the factor is known, on average; total: the part
/// that stays if all others are known. Their difference is interaction with the others.
struct SobolIndex {
  VarianceShare first, total;
};

struct SobolIndices {
  double mean = 0.0, variance = 0.0;
  SobolIndex records;  ///< the choice of the record, from a population of records
  SobolIndex drawn;    ///< all factors together
  std::vector<SobolIndex> factors;
  /// Standard errors of the mean: of as many records as there are, with any number of samples; and
  /// of as many independent samples, on these records.
  double record_error = 0.0, sample_error = 0.0;
};

/// Unbiased for the population that the records are from: products of two responses are taken over
/// pairs of different records. Records and all factors together: components of variance of the
/// two-way design without replication, of all independent samples. A factor: first order by
/// Saltelli et al. (2010), total by Jansen (1999); of given data the first order by the variance
/// between groups (of Sobol points by products of different blocks: their groups scatter less than
/// independent samples), the total is not known (NaN). Equations: theory.md, 6.7. Intervals:
/// jackknife over units (64 groups at most) and over 16 groups of samples, or the blocks, both
/// added (Sobol points in place of independent ones make them somewhat wide); Student t by
/// Satterthwaite. All shares are NaN where the response does not vary. Three units or more, two
/// samples or more.
SobolIndices sobol_indices(const CrossedResponse& response);

}  // namespace glissade
