// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/hdf5_file.hpp"

#include <algorithm>
#include <cstring>

namespace glissade {
namespace {

Hdf5Handle make_space(const Dims& dims) {
  if (dims.empty()) return {H5Screate(H5S_SCALAR), H5Sclose, "make a dataspace"};
  return {H5Screate_simple(static_cast<int>(dims.size()), dims.data(), nullptr), H5Sclose,
          "make a dataspace"};
}

/// Creation properties without times.
Hdf5Handle timeless(hid_t property_class) {
  Hdf5Handle properties(H5Pcreate(property_class), H5Pclose, "make properties");
  checked(H5Pset_obj_track_times(properties, false), "leave times out");
  return properties;
}

Hdf5Handle create(const std::filesystem::path& file) {
  const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "make properties");
  checked(H5Pset_fclose_degree(access, H5F_CLOSE_STRONG), "close all with the file");
  // Nobody else knows the file, and some shared file systems cannot lock.
  checked(H5Pset_file_locking(access, false, true), "leave locks out");
  checked(H5Pset_libver_bounds(access, H5F_LIBVER_EARLIEST, H5F_LIBVER_V18), "fix the format");
  const Hdf5Handle creation = timeless(H5P_FILE_CREATE);
  // Gives the root group the newer object header, whose attributes may be longer than 64 KiB (the
  // study file).
  checked(H5Pset_attr_creation_order(creation, H5P_CRT_ORDER_TRACKED),
          "keep the order of attributes");
  return {H5Fcreate(file.c_str(), H5F_ACC_TRUNC, creation, access), H5Fclose, "begin the file"};
}

void write_attribute(hid_t object, const std::string& name, hid_t in_file, hid_t in_memory,
                     const void* data) {
  const Hdf5Handle space = make_space({});
  const Hdf5Handle attribute(
      H5Acreate2(object, name.c_str(), in_file, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
      "make the attribute " + name);
  checked(H5Awrite(attribute, in_memory, data), "write the attribute " + name);
}

}  // namespace

namespace {

/// Headers of an object, and its part of the index of its group.
constexpr std::size_t beside_bytes = 16384;

}  // namespace

Hdf5OutputFile::Hdf5OutputFile(const std::filesystem::path& partial, OutputFile& file)
    : output_(file), file_([&] {
        output_.reserve(beside_bytes);
        return create(partial);
      }()) {}

void Hdf5OutputFile::reserve(std::size_t bytes) const {
  hsize_t size = 0;
  checked(H5Fget_filesize(file_, &size), "size the file");
  output_.reserve(size + bytes + beside_bytes);
}

void Hdf5OutputFile::close() { file_.close_now("close the file"); }

void Hdf5Writer::write_text_attribute(hid_t object, const std::string& name,
                                      const std::string& text) const {
  file_.reserve(text.size());
  const Hdf5Handle type = text_type(text.size());
  write_attribute(object, name, type, type, text.empty() ? "\0" : text.data());
}

Hdf5Writer Hdf5Writer::group(const std::string& name) const {
  if (H5Lexists(group_, name.c_str(), H5P_DEFAULT) > 0)
    return {
        Hdf5Handle(H5Gopen2(group_, name.c_str(), H5P_DEFAULT), H5Gclose, "open the group " + name),
        file_};
  file_.reserve(0);
  const Hdf5Handle creation = timeless(H5P_GROUP_CREATE);
  return {Hdf5Handle(H5Gcreate2(group_, name.c_str(), H5P_DEFAULT, creation, H5P_DEFAULT), H5Gclose,
                     "make the group " + name),
          file_};
}

void Hdf5Writer::attribute(const std::string& name, const std::string& text) const {
  write_text_attribute(group_, name, text);
}
void Hdf5Writer::attribute(const std::string& name, double value) const {
  write_attribute(group_, name, file_type<double>(), memory_type<double>(), &value);
}
void Hdf5Writer::attribute(const std::string& name, std::uint64_t value) const {
  write_attribute(group_, name, file_type<std::uint64_t>(), memory_type<std::uint64_t>(), &value);
}

void Hdf5Writer::write(const std::string& name, const Label& label, const Dims& dims, hid_t in_file,
                       hid_t in_memory, std::span<const std::byte> values) const {
  const Hdf5Handle space = make_space(dims);
  const DatasetShape shape{dims, H5Tget_size(in_file)};
  const bool chunked = is_chunked(shape) && H5Tget_class(in_file) != H5T_STRING;
  file_.reserve(chunked ? 0 : values.size());
  const Hdf5Handle creation = timeless(H5P_DATASET_CREATE);
  if (chunked) set_chunks(creation, shape);
  const Hdf5Handle dataset(
      H5Dcreate2(group_, name.c_str(), in_file, space, H5P_DEFAULT, creation, H5P_DEFAULT),
      H5Dclose, "make the dataset " + name);
  if (chunked) {
    write_chunks(dataset, shape, values, [&](std::size_t bytes) { file_.reserve(bytes); });
  } else if (!values.empty()) {
    checked(H5Dwrite(dataset, in_memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
            "write the dataset " + name);
  }
  write_text_attribute(dataset, "unit", label.unit);
  write_text_attribute(dataset, "description", label.description);
}

void Hdf5Writer::array(const std::string& name, const Label& label, const Dims& dims,
                       const std::vector<std::string>& values) const {
  std::size_t longest = 1;
  for (const std::string& value : values) longest = std::max(longest, value.size());
  std::string packed;
  for (const std::string& value : values)
    packed += value + std::string(longest - value.size(), '\0');
  const Hdf5Handle type = text_type(longest);
  write(name, label, dims, type, type, std::as_bytes(std::span(packed)));
}

namespace {

Hdf5Handle open_file(const std::filesystem::path& file) {
  const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "make properties");
  // Reading needs no lock, which some shared file systems cannot give.
  checked(H5Pset_file_locking(access, false, true), "leave locks out");
  return {H5Fopen(file.c_str(), H5F_ACC_RDONLY, access), H5Fclose, "open it as HDF5"};
}

std::string text_of(const char* data, std::size_t size) { return {data, strnlen(data, size)}; }

Hdf5Handle open_attribute(hid_t object, const std::string& name) {
  Hdf5Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose,
                       "find the attribute " + name);
  const Hdf5Handle space(H5Aget_space(attribute), H5Sclose, "read the attribute " + name);
  if (H5Sget_simple_extent_npoints(space) != 1)
    throw Hdf5Error("read the attribute " + name + " as a single value");
  return attribute;
}

std::size_t text_size(const Hdf5Handle& type, const std::string& name, std::uintmax_t file_size) {
  const std::size_t size = H5Tget_size(type);
  if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) != 0 || size == 0 ||
      size > file_size) {
    throw Hdf5Error("read " + name + " as text");
  }
  return size;
}

template <class T>
void read_number_attribute(hid_t object, const std::string& name, T& value) {
  const Hdf5Handle attribute = open_attribute(object, name);
  checked(H5Aread(attribute, memory_type<T>(), &value), "read the attribute " + name);
}

}  // namespace

Hdf5Reader::Hdf5Reader(const std::filesystem::path& file)
    : group_(H5Gopen2(open_file(file), "/", H5P_DEFAULT), H5Gclose, "open /"),
      file_size_(std::filesystem::file_size(file)) {}

Hdf5Reader Hdf5Reader::group(const std::string& name) const {
  expect_own(name);
  return {
      Hdf5Handle(H5Gopen2(group_, name.c_str(), H5P_DEFAULT), H5Gclose, "find the group " + name),
      file_size_};
}

bool Hdf5Reader::has(const std::string& name) const {
  return H5Lexists(group_, name.c_str(), H5P_DEFAULT) > 0;
}

void Hdf5Reader::attribute(const std::string& name, std::string& text) const {
  const Hdf5Handle attribute = open_attribute(group_, name);
  const Hdf5Handle type(H5Aget_type(attribute), H5Tclose, "read the attribute " + name);
  const std::size_t size = text_size(type, name, file_size_);
  std::string buffer(size, '\0');
  checked(H5Aread(attribute, type, buffer.data()), "read the attribute " + name);
  text = text_of(buffer.data(), size);
}
void Hdf5Reader::attribute(const std::string& name, double& value) const {
  read_number_attribute(group_, name, value);
}
void Hdf5Reader::attribute(const std::string& name, std::uint64_t& value) const {
  read_number_attribute(group_, name, value);
}

/// Links and storage outside the file could show any file of the reader's, and a compressed piece
/// be of any size: this program writes neither.
void Hdf5Reader::expect_own(const std::string& name) const {
  H5L_info_t link;
  checked(H5Lget_info(group_, name.c_str(), &link, H5P_DEFAULT), "find " + name);
  if (link.type != H5L_TYPE_HARD) throw Hdf5Error("follow " + name + ", which is a link");
}

namespace {

/// Whether a dataset is stored in chunks, or else in one piece, in the file.
bool has_chunks(hid_t dataset, const std::string& name) {
  const Hdf5Handle creation(H5Dget_create_plist(dataset), H5Pclose, "read the dataset " + name);
  const H5D_layout_t layout = H5Pget_layout(creation);
  const bool in_one_piece = (layout == H5D_CONTIGUOUS || layout == H5D_COMPACT) &&
                            H5Pget_external_count(creation) == 0 && H5Pget_nfilters(creation) == 0;
  if (!in_one_piece && layout != H5D_CHUNKED)
    throw Hdf5Error("read the dataset " + name + ", which is not stored in the file");
  return !in_one_piece;
}

}  // namespace

Hdf5Reader::Array Hdf5Reader::open_array(const std::string& name, Dims& dims) const {
  expect_own(name);
  Hdf5Handle dataset(H5Dopen2(group_, name.c_str(), H5P_DEFAULT), H5Dclose,
                     "find the dataset " + name);
  const bool chunked = has_chunks(dataset, name);
  const Hdf5Handle space(H5Dget_space(dataset), H5Sclose, "read the dataset " + name);
  const int rank = checked(H5Sget_simple_extent_ndims(space), "size the dataset " + name);
  if (rank != static_cast<int>(dims.size())) {
    throw Hdf5Error("read the dataset " + name + " in " + std::to_string(dims.size()) +
                    " dimension(s)");
  }
  checked(H5Sget_simple_extent_dims(space, dims.data(), nullptr), "size the dataset " + name);
  const Hdf5Handle type(H5Dget_type(dataset), H5Tclose, "read the dataset " + name);
  const std::size_t value_bytes = std::max<std::size_t>(H5Tget_size(type), 1);
  const std::uintmax_t most_bytes = chunked ? file_size_ * most_inflated : file_size_;
  // A side is compared with the file too: 2^40 rows of nothing would be made room for. The product
  // is formed here, since the library's wraps round.
  std::size_t count = std::ranges::find(dims, hsize_t{0}) == dims.end() ? 1 : 0;
  for (const hsize_t side : dims) {
    if (side > most_bytes || (count > 0 && count > most_bytes / value_bytes / side))
      throw Hdf5Error("read the dataset " + name + ", which is larger than the file");
    count *= side;
  }
  if (chunked) expect_chunks(dataset, {dims, value_bytes}, file_size_, name);
  return {std::move(dataset), value_bytes, count, chunked};
}

void Hdf5Reader::read(const Array& array, const std::string& name, const Dims& dims, hid_t in_file,
                      hid_t in_memory, std::span<std::byte> values) const {
  if (array.count == 0) return;
  if (!array.is_chunked) {
    checked(H5Dread(array.dataset, in_memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
            "read the dataset " + name);
    return;
  }
  const Hdf5Handle type(H5Dget_type(array.dataset), H5Tclose, "read the dataset " + name);
  if (H5Tequal(type, in_file) <= 0)
    throw Hdf5Error("read the dataset " + name + ", whose values are of another type");
  read_chunks(array.dataset, {dims, array.value_bytes}, values, name);
}

std::size_t Hdf5Reader::row_count(const std::string& name, std::size_t rank,
                                  std::size_t row_bytes) const {
  // A row's values differ from row to row, so that a few bytes of the file are of each.
  constexpr std::size_t most_per_byte = 256, always = std::size_t{64} << 20;
  Dims dims(rank);
  open_array(name, dims);
  if (dims.front() > (always + file_size_ * most_per_byte) / row_bytes)
    throw Hdf5Error("read " + name + ", which has more rows than the file can have values for");
  return dims.front();
}

void Hdf5Reader::array(const std::string& name, const Label&, Dims& dims,
                       std::vector<std::string>& values) const {
  const Array array = open_array(name, dims);
  const Hdf5Handle type(H5Dget_type(array.dataset), H5Tclose, "read the dataset " + name);
  const std::size_t size = text_size(type, name, file_size_);
  std::string packed(array.count * size, '\0');
  read(array, name, dims, type, type, std::as_writable_bytes(std::span(packed)));
  values.clear();
  for (std::size_t i = 0; i < array.count; ++i)
    values.push_back(text_of(packed.data() + i * size, size));
}

}  // namespace glissade
