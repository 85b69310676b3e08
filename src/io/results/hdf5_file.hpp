// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "results/hdf5_chunks.hpp"
#include "results/hdf5_handle.hpp"
#include "results/hdf5_output_file.hpp"

namespace glissade {

/// The attributes of every dataset.
struct Label {
  const char* unit;
  const char* description;
};

/// Writes into one group. No times are stored, and sizes and types are fixed: the same content
/// gives the same bytes.
class Hdf5Writer {
 public:
  static constexpr bool reads = false;
  explicit Hdf5Writer(const Hdf5OutputFile& file);
  /// Writes nothing: what the file holds is compared, byte for byte, with what would be written.
  static Hdf5Writer comparing(const std::filesystem::path& file);

  Hdf5Writer group(const std::string& name) const;  ///< one that is there, or a new one
  void attribute(const std::string& name, const std::string& text) const;
  void attribute(const std::string& name, double value) const;
  void attribute(const std::string& name, std::uint64_t value) const;
  template <class T, class Allocator>
  void array(const std::string& name, const Label& label, const Dims& dims,
             const std::vector<T, Allocator>& values) const {
    write(name, label, dims, file_type<T>(), memory_type<T>(), std::as_bytes(std::span(values)));
  }
  void array(const std::string& name, const Label& label, const Dims& dims,
             const std::vector<std::string>& values) const;

 private:
  Hdf5Writer(Hdf5Handle group, const Hdf5OutputFile* file)
      : group_(std::move(group)), file_(file) {}
  void write(const std::string& name, const Label& label, const Dims& dims, hid_t in_file,
             hid_t in_memory, std::span<const std::byte> values) const;
  void write_attribute(hid_t object, const std::string& name, hid_t in_file, hid_t in_memory,
                       std::span<const std::byte> value) const;
  void write_text_attribute(hid_t object, const std::string& name, const std::string& text) const;
  Hdf5Handle group_;
  const Hdf5OutputFile* file_;  ///< null: compares
};

/// The memory that what is read from one file may still take.
class ReadBudget {
 public:
  /// 64 MiB, and no more for each byte of the file than deflate makes of one.
  explicit ReadBudget(std::uintmax_t file_size)
      : left_((std::uintmax_t{64} << 20) + file_size * most_inflated) {}
  void take(const std::string& name, std::uintmax_t count, std::uintmax_t bytes_of_each);

 private:
  std::uintmax_t left_;
};

/// Reads from one group of a file; every trouble is an Hdf5Error that names the dataset. What all
/// readers of the file read together is within its ReadBudget.
class Hdf5Reader {
 public:
  static constexpr bool reads = true;
  explicit Hdf5Reader(const std::filesystem::path& file);

  Hdf5Reader group(const std::string& name) const;
  bool has(const std::string& name) const;
  /// The first side, where the budget has room for so many rows.
  std::size_t row_count(const std::string& name, std::size_t rank, std::size_t row_bytes) const;
  void attribute(const std::string& name, std::string& text) const;
  void attribute(const std::string& name, double& value) const;
  void attribute(const std::string& name, std::uint64_t& value) const;
  template <class T, class Allocator>
  void array(const std::string& name, const Label&, Dims& dims,
             std::vector<T, Allocator>& values) const {
    const Array array = open_array(name, dims);
    budget_->take(name, array.count, sizeof(T));
    values.resize(array.count);
    read(array, name, dims, file_type<T>(), memory_type<T>(),
         std::as_writable_bytes(std::span(values)));
  }
  void array(const std::string& name, const Label& label, Dims& dims,
             std::vector<std::string>& values) const;

 private:
  Hdf5Reader(Hdf5Handle group, const Hdf5Reader& above)
      : group_(std::move(group)), file_size_(above.file_size_), budget_(above.budget_) {}
  void expect_own(const std::string& name) const;
  struct Array {
    Hdf5Handle dataset;
    std::size_t value_bytes, count;
    bool is_chunked;
  };
  Array open_array(const std::string& name, Dims& dims) const;
  void read(const Array& array, const std::string& name, const Dims& dims, hid_t in_file,
            hid_t in_memory, std::span<std::byte> values) const;
  Hdf5Handle group_;
  std::uintmax_t file_size_;  ///< no dataset has more bytes there
  std::shared_ptr<ReadBudget> budget_;
};

}  // namespace glissade
