// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "results/hdf5_handle.hpp"

namespace glissade {

using Dims = std::vector<hsize_t>;

// Large datasets are stored in chunks, each with HDF5's own filters shuffle and deflate, so that
// any program reads them. Chunks are packed and unpacked here, by threads: HDF5 would do it one
// after the other, and let a damaged chunk grow to any size.

/// The values of a dataset as bytes, in C order.
struct DatasetShape {
  Dims dims;
  std::size_t value_bytes;
};

/// Whether a dataset is stored in chunks.
bool is_chunked(const DatasetShape& shape);
/// Adds chunks and filters to the creation properties of a dataset.
void set_chunks(hid_t creation, const DatasetShape& shape);

void write_chunks(hid_t dataset, const DatasetShape& shape, std::span<const std::byte> values);
/// Throws Hdf5Error where the chunks do not hold these values.
void compare_chunks(hid_t dataset, const DatasetShape& shape, std::span<const std::byte> values,
                    const std::string& name);

/// Deflate makes no more than so many bytes of one (zlib, "Maximum Compression Ratio").
constexpr std::size_t most_inflated = 1032;

/// Throws Hdf5Error where a dataset is stored in another way than write_chunks() does, or where its
/// chunks cannot hold that many values.
void expect_chunks(hid_t dataset, const DatasetShape& shape, std::uintmax_t file_size,
                   const std::string& name);
void read_chunks(hid_t dataset, const DatasetShape& shape, std::span<std::byte> values,
                 const std::string& name);

}  // namespace glissade
