// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/hdf5_chunks.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>

#include "glissade/core/in_parallel.hpp"

namespace glissade {
namespace {

constexpr std::size_t chunk_bytes = std::size_t{1} << 18;  // or one row of the last sides
constexpr int fastest = 1;             // of zlib's levels; others are little smaller and slower
constexpr std::size_t at_a_time = 64;  // chunks in memory
constexpr std::array filters = {H5Z_FILTER_SHUFFLE, H5Z_FILTER_DEFLATE};

using Bytes = std::vector<Bytef>;

/// The cut of a dataset: the last sides whole, as many of the side before as fill a chunk, one of
/// each side before that. So the values of a chunk are neighbours in memory.
class Cut {
 public:
  explicit Cut(const DatasetShape& shape) : chunk_(shape.dims.size(), 1), shape_(shape) {
    std::size_t most = std::max<std::size_t>(1, chunk_bytes / shape.value_bytes);
    for (std::size_t side = shape.dims.size(); side-- > 0;) {
      chunk_[side] = std::min<hsize_t>(shape.dims[side], most);
      most /= chunk_[side];
      if (chunk_[side] < shape.dims[side] || most <= 1) break;
    }
    for (std::size_t side = 0; side < chunk_.size(); ++side)
      count_ *= (shape.dims[side] + chunk_[side] - 1) / chunk_[side];
  }
  std::size_t count() const { return count_; }
  const Dims& chunk() const { return chunk_; }
  std::size_t bytes() const {
    std::size_t all = shape_.value_bytes;
    for (const hsize_t side : chunk_) all *= side;
    return all;
  }
  /// The place of a chunk's first value, by side.
  Dims offset(std::size_t chunk) const {
    Dims at(chunk_.size());
    for (std::size_t side = chunk_.size(); side-- > 0;) {
      const std::size_t along = (shape_.dims[side] + chunk_[side] - 1) / chunk_[side];
      at[side] = chunk % along * chunk_[side];
      chunk /= along;
    }
    return at;
  }
  /// The bytes of a chunk within those of the dataset; the last of a row of chunks may be shorter.
  template <class Byte>
  std::span<Byte> of(std::span<Byte> values, std::size_t chunk) const {
    const Dims at = offset(chunk);
    std::size_t first = 0, count = 1;
    for (std::size_t side = 0; side < at.size(); ++side) {
      first = first * shape_.dims[side] + at[side];
      count *= std::min(chunk_[side], shape_.dims[side] - at[side]);
    }
    return values.subspan(first * shape_.value_bytes, count * shape_.value_bytes);
  }

 private:
  Dims chunk_;
  std::size_t count_ = 1;
  const DatasetShape& shape_;
};

/// The position of a value's byte in memory that is the b-th in the file, which is little-endian.
std::size_t in_memory(std::size_t b, std::size_t value_bytes) {
  return std::endian::native == std::endian::little ? b : value_bytes - 1 - b;
}

/// All first bytes, all second bytes ...; deflated.
Bytes packed(std::span<const std::byte> values, std::size_t value_bytes, std::size_t whole_bytes) {
  Bytes shuffled(whole_bytes);
  const std::size_t stride = whole_bytes / value_bytes, count = values.size() / value_bytes;
  for (std::size_t b = 0; b < value_bytes; ++b) {
    for (std::size_t i = 0; i < count; ++i)
      shuffled[b * stride + i] =
          std::to_integer<Bytef>(values[i * value_bytes + in_memory(b, value_bytes)]);
  }
  uLongf size = compressBound(whole_bytes);
  Bytes deflated(size);
  if (compress2(deflated.data(), &size, shuffled.data(), whole_bytes, fastest) != Z_OK)
    throw Hdf5Error("compress a dataset");
  deflated.resize(size);
  return deflated;
}

/// False where they are not those of a whole chunk.
bool unpack(const Bytes& deflated, std::span<std::byte> values, std::size_t value_bytes,
            std::size_t whole_bytes) {
  Bytes shuffled(whole_bytes);
  uLongf size = whole_bytes;
  if (uncompress(shuffled.data(), &size, deflated.data(), deflated.size()) != Z_OK ||
      size != whole_bytes)
    return false;
  const std::size_t stride = whole_bytes / value_bytes, count = values.size() / value_bytes;
  for (std::size_t b = 0; b < value_bytes; ++b) {
    for (std::size_t i = 0; i < count; ++i)
      values[i * value_bytes + in_memory(b, value_bytes)] = std::byte{shuffled[b * stride + i]};
  }
  return true;
}

/// Calls with the first chunk and the number of each batch.
template <class What>
void in_batches(std::size_t chunks, What what) {
  for (std::size_t first = 0; first < chunks; first += at_a_time)
    what(first, std::min(at_a_time, chunks - first));
}

}  // namespace

bool is_chunked(const DatasetShape& shape) {
  std::size_t bytes = shape.value_bytes;
  for (const hsize_t side : shape.dims) bytes *= side;
  return bytes >= chunk_bytes;
}

void set_chunks(hid_t creation, const DatasetShape& shape) {
  const Cut cut(shape);
  checked(H5Pset_chunk(creation, static_cast<int>(cut.chunk().size()), cut.chunk().data()),
          "cut a dataset");
  checked(H5Pset_shuffle(creation), "set a filter");
  checked(H5Pset_deflate(creation, fastest), "set a filter");
}

void write_chunks(hid_t dataset, const DatasetShape& shape, std::span<const std::byte> values) {
  const Cut cut(shape);
  std::array<Bytes, at_a_time> batch;
  in_batches(cut.count(), [&](std::size_t first, std::size_t count) {
    in_parallel(count, [&](std::size_t i) {
      batch[i] = packed(cut.of(values, first + i), shape.value_bytes, cut.bytes());
    });
    for (std::size_t i = 0; i < count; ++i) {
      const Dims at = cut.offset(first + i);
      checked(H5Dwrite_chunk(dataset, H5P_DEFAULT, 0, at.data(), batch[i].size(), batch[i].data()),
              "write a dataset");
    }
  });
}

void expect_chunks(hid_t dataset, const DatasetShape& shape, std::uintmax_t file_size,
                   const std::string& name) {
  const std::string cut_otherwise = "read the dataset " + name + ", which is cut in another way";
  if (!is_chunked(shape)) throw Hdf5Error(cut_otherwise);
  const Hdf5Handle creation(H5Dget_create_plist(dataset), H5Pclose, "read the dataset " + name);
  const int rank = static_cast<int>(shape.dims.size());
  const Cut cut(shape);
  Dims chunk(shape.dims.size());
  bool is_ours = H5Pget_chunk(creation, rank, chunk.data()) == rank && chunk == cut.chunk() &&
                 H5Pget_nfilters(creation) == static_cast<int>(filters.size());
  for (unsigned k = 0; is_ours && k < filters.size(); ++k) {
    std::size_t values = 0;
    is_ours =
        H5Pget_filter2(creation, k, nullptr, &values, nullptr, 0, nullptr, nullptr) == filters[k];
  }
  if (!is_ours) throw Hdf5Error(cut_otherwise);
  const std::uintmax_t stored = std::min<std::uintmax_t>(H5Dget_storage_size(dataset), file_size);
  if (cut.count() > stored * most_inflated / cut.bytes() + 1)
    throw Hdf5Error("read the dataset " + name + ", which is larger than the file");
}

namespace {

/// Takes every chunk, deflated, with the number that it has: false where it is not as it should be.
/// Threads do so, of a batch at a time.
template <class Take>
void take_chunks(hid_t dataset, const Cut& cut, const std::string& name, Take take) {
  const auto damaged = [&] { return Hdf5Error("read the dataset " + name + " whole"); };
  std::array<Bytes, at_a_time> batch;
  std::array<bool, at_a_time> is_whole{};
  in_batches(cut.count(), [&](std::size_t first, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      const Dims at = cut.offset(first + i);
      hsize_t bytes = 0;
      std::uint32_t left_out = 0;  // filters
      if (H5Dget_chunk_storage_size(dataset, at.data(), &bytes) < 0 || bytes == 0 ||
          bytes > compressBound(cut.bytes()))
        throw damaged();
      batch[i].resize(bytes);
      if (H5Dread_chunk(dataset, H5P_DEFAULT, at.data(), &left_out, batch[i].data()) < 0 ||
          left_out != 0)
        throw damaged();
    }
    in_parallel(count, [&](std::size_t i) { is_whole[i] = take(first + i, batch[i]); });
    if (!std::all_of(is_whole.begin(), is_whole.begin() + static_cast<std::ptrdiff_t>(count),
                     [](bool whole) { return whole; }))
      throw damaged();
  });
}

}  // namespace

void read_chunks(hid_t dataset, const DatasetShape& shape, std::span<std::byte> values,
                 const std::string& name) {
  const Cut cut(shape);
  take_chunks(dataset, cut, name, [&](std::size_t chunk, const Bytes& deflated) {
    return unpack(deflated, cut.of(values, chunk), shape.value_bytes, cut.bytes());
  });
}

void compare_chunks(hid_t dataset, const DatasetShape& shape, std::span<const std::byte> values,
                    const std::string& name) {
  const Cut cut(shape);
  take_chunks(dataset, cut, name, [&](std::size_t chunk, const Bytes& deflated) {
    const std::span<const std::byte> meant = cut.of(values, chunk);
    std::vector<std::byte> found(meant.size());
    return unpack(deflated, found, shape.value_bytes, cut.bytes()) &&
           std::ranges::equal(found, meant);
  });
}

}  // namespace glissade
