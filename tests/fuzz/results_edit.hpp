// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hdf5.h>

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "bytes.hpp"

namespace glissade::fuzz {

/// The names of all objects of an HDF5 file.
inline std::vector<std::string> names_in(const std::filesystem::path& file) {
  std::vector<std::string> names;
  const auto remember = [](hid_t, const char* name, const H5L_info_t*, void* into) {
    static_cast<std::vector<std::string>*>(into)->emplace_back(name);
    return herr_t{0};
  };
  const hid_t opened = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  H5Lvisit(opened, H5_INDEX_NAME, H5_ITER_INC, remember, &names);
  H5Fclose(opened);
  return names;
}

/// Edits a results file as the input says, four bytes and more to an edit: deletes an object or
/// puts another in its place. The file stays whole for the HDF5 library, which is not what is
/// tested here and does not stand arbitrary bytes. Errors of HDF5 are of no interest: an edit that
/// cannot be made is not made.
class ResultsEditor {
 public:
  /// `names` are those of the objects that the file had.
  ResultsEditor(const std::filesystem::path& file, const std::vector<std::string>& names)
      : file_(H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT)), names_(names) {}
  ~ResultsEditor() { H5Fclose(file_); }
  ResultsEditor(const ResultsEditor&) = delete;
  ResultsEditor& operator=(const ResultsEditor&) = delete;

  void edit(Bytes& bytes) {
    const auto what = bytes.take<std::uint8_t>();
    const std::string& name = names_[bytes.take<std::uint8_t>() % names_.size()];
    switch (what % 6) {
      case 0:
        H5Ldelete(file_, name.c_str(), H5P_DEFAULT);
        break;
      case 1:
        put_dataset(name, bytes);
        break;
      case 2:
        put_attribute(bytes);
        break;
      case 3:
        overwrite(name, bytes);
        break;
      case 4:
        put_link(name, bytes);
        break;
      case 5:
        put_group(name);
        break;
    }
  }

 private:
  static hid_t take_type(Bytes& bytes) {
    static const std::array<hid_t, 7> numbers = {H5T_IEEE_F64LE, H5T_STD_U64LE,  H5T_STD_I32LE,
                                                 H5T_STD_U8LE,   H5T_IEEE_F32BE, H5T_STD_I64BE,
                                                 H5T_STD_REF_OBJ};
    const auto which = bytes.take<std::uint8_t>();
    if (which < 200) return H5Tcopy(numbers[which % numbers.size()]);
    const hid_t text = H5Tcopy(H5T_C_S1);
    H5Tset_size(text, which == 255 ? H5T_VARIABLE : 1u + which - 200u);
    return text;
  }

  /// Of rank 0 to 3, each side none, small or enormous; an attribute's not, which is stored at
  /// once.
  static hid_t take_space(Bytes& bytes, bool enormous) {
    static const std::array<hsize_t, 8> sides = {0, 1, 2, 3, 4, 5, 1000, hsize_t{1} << 40};
    const int rank = bytes.take<std::uint8_t>() % 4;
    std::array<hsize_t, 3> dims{};
    for (hsize_t& side : dims)
      side = sides[bytes.take<std::uint8_t>() % (enormous ? sides.size() : sides.size() - 2)];
    return rank == 0 ? H5Screate(H5S_SCALAR) : H5Screate_simple(rank, dims.data(), nullptr);
  }

  void put_dataset(const std::string& name, Bytes& bytes) {
    H5Ldelete(file_, name.c_str(), H5P_DEFAULT);
    const hid_t type = take_type(bytes), space = take_space(bytes, true);
    // Without a value written it takes no room, however large.
    const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_alloc_time(creation, H5D_ALLOC_TIME_LATE);
    const hid_t set =
        H5Dcreate2(file_, name.c_str(), type, space, H5P_DEFAULT, creation, H5P_DEFAULT);
    if (set >= 0) H5Dclose(set);
    H5Pclose(creation);
    H5Sclose(space);
    H5Tclose(type);
  }

  void put_attribute(Bytes& bytes) {
    static const std::array<const char*, 6> known = {
        "file_type", "format_version", "seed", "study_name", "intensity_measure", "plan_hash"};
    const char* name = known[bytes.take<std::uint8_t>() % known.size()];
    H5Adelete(file_, name);
    const hid_t type = take_type(bytes), space = take_space(bytes, false);
    const hid_t attribute = H5Acreate2(file_, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
    if (attribute >= 0) H5Aclose(attribute);
    H5Sclose(space);
    H5Tclose(type);
  }

  /// Other values of the same type and shape, if they are few.
  void overwrite(const std::string& name, Bytes& bytes) {
    const hid_t set = H5Dopen2(file_, name.c_str(), H5P_DEFAULT);
    if (set < 0) return;
    const hid_t type = H5Dget_type(set), space = H5Dget_space(set);
    const hssize_t count = H5Sget_simple_extent_npoints(space);
    if (H5Tis_variable_str(type) == 0 && count > 0 && count < 1000) {
      std::vector<std::uint8_t> values(static_cast<std::size_t>(count) * H5Tget_size(type));
      for (std::uint8_t& value : values) value = bytes.take<std::uint8_t>();
      H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    }
    H5Sclose(space);
    H5Tclose(type);
    H5Dclose(set);
  }

  void put_link(const std::string& name, Bytes& bytes) {
    const std::string target = "/" + names_[bytes.take<std::uint8_t>() % names_.size()];
    H5Ldelete(file_, name.c_str(), H5P_DEFAULT);
    H5Lcreate_soft(target.c_str(), file_, name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
  }

  void put_group(const std::string& name) {
    H5Ldelete(file_, name.c_str(), H5P_DEFAULT);
    const hid_t group = H5Gcreate2(file_, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    if (group >= 0) H5Gclose(group);
  }

  hid_t file_;
  const std::vector<std::string>& names_;
};

}  // namespace glissade::fuzz
