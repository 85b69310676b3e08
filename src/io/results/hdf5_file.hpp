// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "glissade/core/output_file.hpp"
#include "results/hdf5_chunks.hpp"
#include "results/hdf5_handle.hpp"

namespace glissade {

/// The attributes of every dataset.
struct Label {
  const char* unit;
  const char* description;
};

/// An HDF5 file while it is written. Disk space is reserved before HDF5 needs it: HDF5 cannot close
/// a file that met a full disk.
class Hdf5OutputFile {
 public:
  /// @param partial an empty file, which `file` has open
  Hdf5OutputFile(const std::filesystem::path& partial, OutputFile& file);
  hid_t root() const { return file_; }
  /// Before so many bytes of content are written, and what HDF5 writes beside them.
  void reserve(std::size_t bytes) const;
  void close();

 private:
  OutputFile& output_;
  Hdf5Handle file_;
};

/// Writes into one group. No times are stored, and sizes and types are fixed: the same content
/// gives the same bytes.
class Hdf5Writer {
 public:
  static constexpr bool reads = false;
  explicit Hdf5Writer(const Hdf5OutputFile& file)
      : group_(H5Gopen2(file.root(), "/", H5P_DEFAULT), H5Gclose, "open /"), file_(file) {}

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
  Hdf5Writer(Hdf5Handle group, const Hdf5OutputFile& file)
      : group_(std::move(group)), file_(file) {}
  void write(const std::string& name, const Label& label, const Dims& dims, hid_t in_file,
             hid_t in_memory, std::span<const std::byte> values) const;
  void write_text_attribute(hid_t object, const std::string& name, const std::string& text) const;
  Hdf5Handle group_;
  const Hdf5OutputFile& file_;
};

/// Reads from one group of a file; every trouble is an Hdf5Error that names the dataset.
class Hdf5Reader {
 public:
  static constexpr bool reads = true;
  explicit Hdf5Reader(const std::filesystem::path& file);

  Hdf5Reader group(const std::string& name) const;
  bool has(const std::string& name) const;
  /// The first side; refused where so many rows need far more memory than the file has bytes.
  std::size_t row_count(const std::string& name, std::size_t rank, std::size_t row_bytes) const;
  void attribute(const std::string& name, std::string& text) const;
  void attribute(const std::string& name, double& value) const;
  void attribute(const std::string& name, std::uint64_t& value) const;
  template <class T, class Allocator>
  void array(const std::string& name, const Label&, Dims& dims,
             std::vector<T, Allocator>& values) const {
    const Array array = open_array(name, dims);
    values.resize(array.count);
    read(array, name, dims, file_type<T>(), memory_type<T>(),
         std::as_writable_bytes(std::span(values)));
  }
  void array(const std::string& name, const Label& label, Dims& dims,
             std::vector<std::string>& values) const;

 private:
  Hdf5Reader(Hdf5Handle group, std::uintmax_t file_size)
      : group_(std::move(group)), file_size_(file_size) {}
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
};

}  // namespace glissade
