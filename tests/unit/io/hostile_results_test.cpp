// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <hdf5.h>

#include <bit>
#include <cstdlib>
#include <cstring>
#include <limits>

#include "fuzz/results_edit.hpp"
#include "misfits.hpp"
#include "problems.hpp"
#include "renew_checksum.hpp"
#include "whole_report.hpp"

// Results files whose numbers somebody has changed, and whose checksum was renewed: what the reader
// itself checks. Each is refused with a message, or a report can be made of it.
namespace glissade {
namespace {

namespace fs = std::filesystem;

struct Outcomes {
  int refused = 0, reported = 0;
};

class HostileResults : public testing::Test {
 protected:
  HostileResults() {
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    write_results(file_, test::with_everything());
    names_ = fuzz::names_in(file_);
    whole_ = read_text_file(file_);
  }

  /// Looks into the good file.
  template <class Look>
  void looked_at(const Look& look) {
    folder_.write("a.h5", whole_);
    const hid_t file = H5Fopen(file_.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    look(file);
    H5Fclose(file);
  }
  /// Edits a copy of it.
  template <class Edit>
  void edited(const Edit& edit) {
    folder_.write("a.h5", whole_);
    const hid_t file = H5Fopen(file_.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    const bool is_edited = edit(file);
    ASSERT_GE(H5Fclose(file), 0);
    test::renew_checksum(file_);
    if (is_edited) take_outcome();
  }
  void take_outcome() {
    Results results;
    try {
      results = read_results(file_);
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr("a.h5"));
      ++outcomes_.refused;
      return;
    }
    EXPECT_NO_THROW(EXPECT_NE(report_of(results).page, ""));
    ++outcomes_.reported;
  }
  /// One of `part_of_edits` is tried; with GLISSADE_HOSTILE=NAME every edit of the objects that
  /// have NAME in their paths; empty: of all.
  bool is_tried(const std::string& name) {
    static const char* const chosen = getenv("GLISSADE_HOSTILE");
    constexpr int part_of_edits = 37;  // shares no factor with the numbers and places of a dataset
    return chosen != nullptr ? name.find(chosen) != std::string::npos
                             : edits_++ % part_of_edits == 0;
  }
  /// Some of both: the edits are made, and not all of them break the file.
  void expect_both() const {
    EXPECT_GT(outcomes_.refused, 0);
    EXPECT_GT(outcomes_.reported, 0);
    std::printf("%d refused, %d reported\n", outcomes_.refused, outcomes_.reported);
  }

  TemporaryFolder folder_;
  const fs::path file_ = folder_.path() / "a.h5";
  std::vector<std::string> names_;  ///< of its groups and datasets
  std::string whole_;
  Outcomes outcomes_;
  int edits_ = 0;
};

/// Bytes of one number of a file, which is little-endian; none for text.
using Number = std::vector<std::uint8_t>;

template <class T>
Number bytes_of_number(T value) {
  Number bytes(sizeof value);
  std::memcpy(bytes.data(), &value, sizeof value);
  return bytes;
}

/// What arithmetic, sizes and lists are broken by.
std::vector<Number> hostile_numbers(hid_t type) {
  using Limits = std::numeric_limits<double>;
  std::vector<Number> numbers;
  const std::size_t size = H5Tget_size(type);
  if (H5Tget_class(type) == H5T_FLOAT) {
    for (const double x : {Limits::quiet_NaN(), Limits::infinity(), -1.0, 0.0, Limits::max(),
                           -Limits::max(), Limits::denorm_min()})
      numbers.push_back(size == sizeof(float) ? bytes_of_number(static_cast<float>(x))
                                              : bytes_of_number(x));
  } else if (H5Tget_class(type) == H5T_INTEGER) {
    numbers = {Number(size, 0x00), Number(size, 0xff), Number(size, 0x7f), Number(size, 0x00)};
    numbers[3][0] = 1;
  }
  return numbers;
}

/// Puts a number into a dataset in place of all its values, or of the last.
bool put_number(hid_t file, const std::string& name, const Number& number, bool in_all) {
  const hid_t set = H5Dopen2(file, name.c_str(), H5P_DEFAULT);
  const hid_t type = H5Dget_type(set), space = H5Dget_space(set);
  const auto count = static_cast<std::size_t>(H5Sget_simple_extent_npoints(space));
  Number values(count * number.size());
  bool is_put = count > 0 && H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0;
  if (is_put) {
    for (std::size_t i = in_all ? 0 : count - 1; i < count; ++i)
      std::ranges::copy(number, values.begin() + static_cast<std::ptrdiff_t>(i * number.size()));
    is_put = H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0;
  }
  H5Sclose(space);
  H5Tclose(type);
  H5Dclose(set);
  return is_put;
}

/// The type of a dataset, to be closed; negative: it is a group.
hid_t type_of(hid_t file, const std::string& name) {
  const hid_t set = H5Dopen2(file, name.c_str(), H5P_DEFAULT);
  const hid_t type = set < 0 ? H5I_INVALID_HID : H5Dget_type(set);
  if (set >= 0) H5Dclose(set);
  return type;
}

TEST_F(HostileResults, with_other_numbers_in_any_dataset_are_refused_or_reported) {
  std::vector<std::vector<Number>> numbers_of;
  looked_at([&](hid_t file) {
    for (const std::string& name : names_) {
      const hid_t type = type_of(file, name);
      numbers_of.push_back(type < 0 ? std::vector<Number>() : hostile_numbers(type));
      if (type >= 0) H5Tclose(type);
    }
  });
  for (std::size_t k = 0; k < names_.size(); ++k) {
    const std::string& name = names_[k];
    const std::vector<Number>& numbers = numbers_of[k];
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      for (const bool in_all : {true, false}) {
        if (!is_tried(name)) continue;
        SCOPED_TRACE(name + ", number " + std::to_string(i) + (in_all ? ", in all" : ", last"));
        edited([&](hid_t file) { return put_number(file, name, numbers[i], in_all); });
      }
    }
  }
  expect_both();
}

/// A side of a dataset is one longer, and all its values are zero.
bool put_longer(hid_t file, const std::string& name, int side) {
  const hid_t set = H5Dopen2(file, name.c_str(), H5P_DEFAULT);
  if (set < 0) return false;
  const hid_t type = H5Dget_type(set), space = H5Dget_space(set);
  std::array<hsize_t, 4> sides{};
  const int rank = H5Sget_simple_extent_ndims(space);
  bool is_put = side < rank;
  H5Dclose(set);
  if (is_put) {
    H5Sget_simple_extent_dims(space, sides.data(), nullptr);
    ++sides[static_cast<std::size_t>(side)];
    H5Ldelete(file, name.c_str(), H5P_DEFAULT);
    const hid_t longer = H5Screate_simple(rank, sides.data(), nullptr);
    const hid_t put =
        H5Dcreate2(file, name.c_str(), type, longer, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    is_put = put >= 0;
    H5Dclose(put);
    H5Sclose(longer);
  }
  H5Sclose(space);
  H5Tclose(type);
  return is_put;
}

TEST_F(HostileResults, with_a_dataset_of_another_size_are_refused) {
  for (const std::string& name : names_) {
    for (int side = 0; side < 3; ++side) {
      SCOPED_TRACE(name + ", side " + std::to_string(side));
      edited([&](hid_t file) { return put_longer(file, name, side); });
    }
  }
  EXPECT_GT(outcomes_.refused, 50);
  std::printf("%d refused, %d reported\n", outcomes_.refused, outcomes_.reported);
}

/// The names of the numbers among the attributes of an object.
std::vector<std::string> attributes_of(hid_t object) {
  std::vector<std::string> names;
  const auto remember = [](hid_t, const char* name, const H5A_info_t*, void* into) {
    static_cast<std::vector<std::string>*>(into)->emplace_back(name);
    return herr_t{0};
  };
  hsize_t from = 0;
  H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_INC, &from, remember, &names);
  return names;
}

TEST_F(HostileResults, with_other_numbers_in_any_attribute_are_refused_or_reported) {
  names_.emplace_back(".");  // the root
  for (const std::string& name : names_) {
    std::vector<std::pair<std::string, Number>> edits;
    const auto object_of = [&](hid_t file) { return H5Oopen(file, name.c_str(), H5P_DEFAULT); };
    looked_at([&](hid_t file) {
      const hid_t object = object_of(file);
      for (const std::string& attribute : attributes_of(object)) {
        const hid_t opened = H5Aopen(object, attribute.c_str(), H5P_DEFAULT);
        const hid_t type = H5Aget_type(opened);
        for (const Number& number : hostile_numbers(type)) edits.emplace_back(attribute, number);
        H5Tclose(type);
        H5Aclose(opened);
      }
      H5Oclose(object);
    });
    for (const auto& [attribute, number] : edits) {
      SCOPED_TRACE(name + ", attribute " + attribute);
      edited([&](hid_t file) {
        const hid_t object = object_of(file);
        const hid_t opened = H5Aopen(object, attribute.c_str(), H5P_DEFAULT);
        const hid_t type = H5Aget_type(opened);
        const bool is_put = H5Awrite(opened, type, number.data()) >= 0;
        H5Tclose(type);
        H5Aclose(opened);
        H5Oclose(object);
        return is_put;
      });
    }
  }
  expect_both();
}

}  // namespace
}  // namespace glissade
