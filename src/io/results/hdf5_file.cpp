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

Hdf5Handle open_file(const std::filesystem::path& file) {
  const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "make properties");
  // Reading needs no lock, which some shared file systems cannot give.
  checked(H5Pset_file_locking(access, false, true), "leave locks out");
  return {H5Fopen(file.c_str(), H5F_ACC_RDONLY, access), H5Fclose, "open it as HDF5"};
}

Hdf5Handle root_of(hid_t file) { return {H5Gopen2(file, "/", H5P_DEFAULT), H5Gclose, "open /"}; }

Hdf5Handle make_dataset(hid_t group, const std::string& name, hid_t type, const DatasetShape& shape,
                        bool chunked) {
  const Hdf5Handle space = make_space(shape.dims);
  const Hdf5Handle creation = timeless(H5P_DATASET_CREATE);
  if (chunked) set_chunks(creation, shape);
  return {H5Dcreate2(group, name.c_str(), type, space, H5P_DEFAULT, creation, H5P_DEFAULT),
          H5Dclose, "make the dataset " + name};
}

Hdf5Handle open_dataset(hid_t group, const std::string& name) {
  return {H5Dopen2(group, name.c_str(), H5P_DEFAULT), H5Dclose, "find the dataset " + name};
}

/// Throws unless an attribute or dataset is of this type and of as many values.
void expect_same(const Hdf5Handle& type, const Hdf5Handle& space, hid_t in_file, const Dims& dims,
                 const std::string& name) {
  Dims found(dims.size());
  if (H5Tequal(type, in_file) <= 0 ||
      H5Sget_simple_extent_ndims(space) != static_cast<int>(dims.size()) ||
      H5Sget_simple_extent_dims(space, found.data(), nullptr) < 0 || found != dims)
    throw Hdf5Error("find " + name + " as it was written");
}

/// Throws unless what `read` reads is the same.
template <class Read>
void expect_same(std::span<const std::byte> meant, const std::string& name, Read read) {
  std::vector<std::byte> found(meant.size());
  checked(read(found.data()), "read " + name + " again");
  if (!std::ranges::equal(found, meant)) throw Hdf5Error("find " + name + " as it was written");
}

}  // namespace

Hdf5Writer::Hdf5Writer(const Hdf5OutputFile& file) : Hdf5Writer(root_of(file.root()), &file) {}

Hdf5Writer Hdf5Writer::comparing(const std::filesystem::path& file) {
  return {root_of(open_file(file)), nullptr};
}

Hdf5Writer Hdf5Writer::group(const std::string& name) const {
  if (file_ == nullptr || H5Lexists(group_, name.c_str(), H5P_DEFAULT) > 0)
    return {
        Hdf5Handle(H5Gopen2(group_, name.c_str(), H5P_DEFAULT), H5Gclose, "open the group " + name),
        file_};
  const Hdf5Handle creation = timeless(H5P_GROUP_CREATE);
  return {Hdf5Handle(H5Gcreate2(group_, name.c_str(), H5P_DEFAULT, creation, H5P_DEFAULT), H5Gclose,
                     "make the group " + name),
          file_};
}

void Hdf5Writer::write_attribute(hid_t object, const std::string& name, hid_t in_file,
                                 hid_t in_memory, std::span<const std::byte> value) const {
  if (file_ == nullptr) {
    const Hdf5Handle found(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose, "find " + name);
    expect_same({H5Aget_type(found), H5Tclose, "read " + name},
                {H5Aget_space(found), H5Sclose, "read " + name}, in_file, {}, name);
    return expect_same(value, name, [&](void* into) { return H5Aread(found, in_memory, into); });
  }
  const Hdf5Handle space = make_space({});
  Hdf5Handle attribute(H5Acreate2(object, name.c_str(), in_file, space, H5P_DEFAULT, H5P_DEFAULT),
                       H5Aclose, "make the attribute " + name);
  checked(H5Awrite(attribute, in_memory, value.data()), "write the attribute " + name);
  attribute.close_now("write the attribute " + name);
}

void Hdf5Writer::write_text_attribute(hid_t object, const std::string& name,
                                      const std::string& text) const {
  const Hdf5Handle type = text_type(text.size());
  const std::string_view bytes = text.empty() ? std::string_view("\0", 1) : text;
  write_attribute(object, name, type, type, std::as_bytes(std::span(bytes)));
}

void Hdf5Writer::attribute(const std::string& name, const std::string& text) const {
  write_text_attribute(group_, name, text);
}
void Hdf5Writer::attribute(const std::string& name, double value) const {
  write_attribute(group_, name, file_type<double>(), memory_type<double>(),
                  std::as_bytes(std::span(&value, 1)));
}
void Hdf5Writer::attribute(const std::string& name, std::uint64_t value) const {
  write_attribute(group_, name, file_type<std::uint64_t>(), memory_type<std::uint64_t>(),
                  std::as_bytes(std::span(&value, 1)));
}

void Hdf5Writer::write(const std::string& name, const Label& label, const Dims& dims, hid_t in_file,
                       hid_t in_memory, std::span<const std::byte> values) const {
  const DatasetShape shape{dims, H5Tget_size(in_file)};
  const bool chunked = is_chunked(shape) && H5Tget_class(in_file) != H5T_STRING;
  Hdf5Handle dataset = file_ == nullptr ? open_dataset(group_, name)
                                        : make_dataset(group_, name, in_file, shape, chunked);
  if (file_ == nullptr) {
    expect_same({H5Dget_type(dataset), H5Tclose, "read " + name},
                {H5Dget_space(dataset), H5Sclose, "read " + name}, in_file, dims, name);
    if (chunked)
      compare_chunks(dataset, shape, values, name);
    else if (!values.empty())
      expect_same(values, name, [&](void* into) {
        return H5Dread(dataset, in_memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, into);
      });
  } else if (chunked) {
    write_chunks(dataset, shape, values);
  } else if (!values.empty()) {
    checked(H5Dwrite(dataset, in_memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
            "write the dataset " + name);
  }
  write_text_attribute(dataset, "unit", label.unit);
  write_text_attribute(dataset, "description", label.description);
  dataset.close_now("write the dataset " + name);
  if (file_ != nullptr) file_->throw_failure();
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

std::string text_of(const char* data, std::size_t size) { return {data, strnlen(data, size)}; }

Hdf5Handle open_attribute(hid_t object, const std::string& name) {
  Hdf5Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose,
                       "find the attribute " + name);
  const Hdf5Handle space(H5Aget_space(attribute), H5Sclose, "read the attribute " + name);
  if (H5Sget_simple_extent_npoints(space) != 1)
    throw Hdf5Error("read the attribute " + name + " as a single value");
  return attribute;
}

std::size_t text_size(const Hdf5Handle& type, const std::string& name) {
  const std::size_t size = H5Tget_size(type);
  if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) != 0 || size == 0)
    throw Hdf5Error("read " + name + " as text");
  return size;
}

template <class T>
void read_number_attribute(hid_t object, const std::string& name, T& value) {
  const Hdf5Handle attribute = open_attribute(object, name);
  checked(H5Aread(attribute, memory_type<T>(), &value), "read the attribute " + name);
}

}  // namespace

void ReadBudget::take(const std::string& name, std::uintmax_t count, std::uintmax_t bytes_of_each) {
  if (count > left_ / bytes_of_each)
    throw Hdf5Error("read " + name + ", which needs far more memory than the file has bytes");
  left_ -= count * bytes_of_each;
}

Hdf5Reader::Hdf5Reader(const std::filesystem::path& file)
    : group_(root_of(open_file(file))),
      file_size_(std::filesystem::file_size(file)),
      budget_(std::make_shared<ReadBudget>(file_size_)) {}

Hdf5Reader Hdf5Reader::group(const std::string& name) const {
  expect_own(name);
  return {
      Hdf5Handle(H5Gopen2(group_, name.c_str(), H5P_DEFAULT), H5Gclose, "find the group " + name),
      *this};
}

bool Hdf5Reader::has(const std::string& name) const {
  return H5Lexists(group_, name.c_str(), H5P_DEFAULT) > 0;
}

void Hdf5Reader::attribute(const std::string& name, std::string& text) const {
  const Hdf5Handle attribute = open_attribute(group_, name);
  const Hdf5Handle type(H5Aget_type(attribute), H5Tclose, "read the attribute " + name);
  const std::size_t size = text_size(type, name);
  budget_->take(name, size, 2);  // with the buffer
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
  Hdf5Handle dataset = open_dataset(group_, name);
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
  Dims dims(rank);
  open_array(name, dims);
  budget_->take(name, dims.front(), row_bytes);
  return dims.front();
}

void Hdf5Reader::array(const std::string& name, const Label&, Dims& dims,
                       std::vector<std::string>& values) const {
  const Array array = open_array(name, dims);
  const Hdf5Handle type(H5Dget_type(array.dataset), H5Tclose, "read the dataset " + name);
  const std::size_t size = text_size(type, name);
  if (array.is_chunked) throw Hdf5Error("read the text " + name + ", which is stored in chunks");
  budget_->take(name, array.count, sizeof(std::string) + 2 * size);
  std::string packed(array.count * size, '\0');
  read(array, name, dims, type, type, std::as_writable_bytes(std::span(packed)));
  values.clear();
  for (std::size_t i = 0; i < array.count; ++i)
    values.push_back(text_of(packed.data() + i * size, size));
}

}  // namespace glissade
