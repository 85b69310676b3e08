// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/hdf5_chunks.hpp"

#include <gmock/gmock.h>
#include <hdf5.h>
#include <tbb/global_control.h>
#include <zlib.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <random>

#include "glissade/core/file.hpp"
#include "problems.hpp"
#include "renew_checksum.hpp"
#include "temporary_folder.hpp"

namespace glissade {
namespace {

constexpr ResultsKind kind{"test", 1, "test file"};

/// Some zero, some any bits, some not numbers.
std::vector<double> some_values(std::size_t count) {
  std::mt19937_64 random(7);
  std::vector<double> values(count);
  for (double& value : values) {
    const auto bits = random();
    if (bits % 4 != 0) value = bits % 4 == 1 ? std::nan("") : std::bit_cast<double>(random());
  }
  return values;
}

template <class T>
void write(const std::filesystem::path& file, const Dims& dims, const std::vector<T>& values) {
  write_results_of(kind, file, [&](const Hdf5Writer& root) {
    root.array("x", {"m", "values"}, dims, values);
  });
}

template <class T>
std::vector<T> read(const std::filesystem::path& file, std::size_t sides, Dims* found = nullptr) {
  std::vector<T> values;
  Dims dims(sides);
  read_results_of(kind, file, [&](const Hdf5Reader& root) { root.array("x", {}, dims, values); });
  if (found != nullptr) *found = dims;
  return values;
}

/// By the library's own filters.
std::vector<double> read_by_hdf5(const std::filesystem::path& file, std::size_t count) {
  const hid_t id = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t set = H5Dopen2(id, "x", H5P_DEFAULT);
  std::vector<double> values(count);
  EXPECT_GE(H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
  H5Dclose(set);
  H5Fclose(id);
  return values;
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

TEST(hdf5_chunks, come_back_to_the_last_bit_and_are_read_by_the_library_too) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "a.h5";
  for (const Dims& dims :
       {Dims{7, 5001, 3}, Dims{100001}, Dims{2, 3, 40000}, Dims{3, 2, 5000, 9}}) {
    std::size_t count = 1;
    for (const hsize_t side : dims) count *= side;
    const std::vector<double> values = some_values(count);
    write(file, dims, values);
    EXPECT_LT(std::filesystem::file_size(file), 0.8 * static_cast<double>(count * sizeof(double)));
    Dims found;
    EXPECT_TRUE(same_bits(read<double>(file, dims.size(), &found), values));
    EXPECT_EQ(found, dims);
    EXPECT_TRUE(same_bits(read_by_hdf5(file, count), values));
  }
  std::vector<std::uint8_t> flags(std::size_t{1} << 20);
  for (std::size_t i = 0; i < flags.size(); ++i) flags[i] = i % 7 == 0 ? 1 : 0;
  write(file, {flags.size()}, flags);
  EXPECT_EQ(read<std::uint8_t>(file, 1), flags);
}

TEST(hdf5_chunks, are_the_same_bytes_by_any_number_of_threads) {
  const TemporaryFolder folder;
  const std::vector<double> values = some_values(1 << 19);
  std::string first;
  for (const std::size_t threads : {1, 2, 5}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    write(folder.path() / "a.h5", {values.size()}, values);
    const std::string bytes = read_text_file(folder.path() / "a.h5");
    if (first.empty()) first = bytes;
    EXPECT_TRUE(bytes == first) << threads;
  }
}

/// What reading says of a file in which x is replaced.
template <class Replace, class Read>
std::string refusal(const Replace& replace, const Read& read_it) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "a.h5";
  write<double>(file, {1}, {0.0});
  const hid_t id = H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  EXPECT_GE(H5Ldelete(id, "x", H5P_DEFAULT), 0);
  replace(id);
  EXPECT_GE(H5Fclose(id), 0);
  test::renew_checksum(file);
  return message_of([&] { read_it(file); });
}
template <class Replace>
std::string refusal(const Replace& replace) {
  return refusal(replace, [](const std::filesystem::path& file) { read<double>(file, 1); });
}

constexpr hsize_t side = 1 << 17;
hid_t create_x(hid_t file, hsize_t count, const hid_t creation) {
  const hid_t space = H5Screate_simple(1, &count, nullptr);
  const hid_t set =
      H5Dcreate2(file, "x", H5T_IEEE_F64LE, space, H5P_DEFAULT, creation, H5P_DEFAULT);
  EXPECT_GE(set, 0);
  H5Sclose(space);
  return set;
}
hid_t cut_as_ours(hsize_t count) {
  const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
  set_chunks(creation, {{count}, sizeof(double)});
  return creation;
}

/// A dataset of which all chunks are these bytes, deflated.
std::string refusal_of_chunks(std::size_t bytes, std::uint32_t filters_left_out = 0) {
  return refusal([&](hid_t file) {
    const hid_t creation = cut_as_ours(side);
    const hid_t set = create_x(file, side, creation);
    hsize_t chunk = 0;
    H5Pget_chunk(creation, 1, &chunk);
    const std::vector<Bytef> zeros(bytes);
    uLongf size = compressBound(bytes);
    std::vector<Bytef> deflated(size);
    compress(deflated.data(), &size, zeros.data(), bytes);
    for (hsize_t at = 0; at < side; at += chunk)
      EXPECT_GE(H5Dwrite_chunk(set, H5P_DEFAULT, filters_left_out, &at, size, deflated.data()), 0);
    H5Dclose(set);
  });
}

TEST(hdf5_chunks, that_are_damaged_are_refused) {
  constexpr std::size_t whole = std::size_t{1} << 18;
  EXPECT_EQ(refusal_of_chunks(whole), "");
  EXPECT_THAT(refusal_of_chunks(whole - 1), test::states("x", "whole"));
  EXPECT_THAT(refusal_of_chunks(64 * whole), test::states("x", "whole"));  // would grow
  EXPECT_THAT(refusal_of_chunks(whole, 2), test::states("x", "whole"));    // said to be undeflated
  const auto empty = [](hid_t file) { H5Dclose(create_x(file, side, cut_as_ours(side))); };
  EXPECT_THAT(refusal(empty), test::states("x"));
}

TEST(hdf5_chunks, of_another_cut_or_of_more_than_the_file_can_hold_are_refused) {
  const auto cut = [](hsize_t chunk) {
    return refusal([&](hid_t file) {
      const hid_t creation = cut_as_ours(side);
      H5Pset_chunk(creation, 1, &chunk);
      H5Dclose(create_x(file, side, creation));
    });
  };
  EXPECT_THAT(cut(1), test::states("x", "cut in another way"));
  EXPECT_THAT(cut(side), test::states("x", "cut in another way"));
  const auto without_rows = [](hid_t file) {
    const hsize_t none = 0, unlimited = H5S_UNLIMITED, chunk = 1;
    const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_chunk(creation, 1, &chunk);
    const hid_t space = H5Screate_simple(1, &none, &unlimited);
    H5Dclose(H5Dcreate2(file, "x", H5T_IEEE_F64LE, space, H5P_DEFAULT, creation, H5P_DEFAULT));
    H5Sclose(space);
  };
  EXPECT_THAT(refusal(without_rows), test::states("x", "cut in another way"));
  for (const hsize_t count : {hsize_t{1} << 24, hsize_t{1} << 40}) {
    const auto huge = [&](hid_t file) { H5Dclose(create_x(file, count, cut_as_ours(count))); };
    EXPECT_THAT(refusal(huge), test::states("x", "larger"));
  }
}

// All values the same, so that the file is small.
TEST(hdf5_chunks, of_far_more_rows_than_the_file_has_bytes_are_refused) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "a.h5";
  write<double>(file, {side}, std::vector<double>(side));
  const auto rows = [&](std::size_t row_bytes) {
    std::size_t count = 0;
    read_results_of(kind, file,
                    [&](const Hdf5Reader& root) { count = root.row_count("x", 1, row_bytes); });
    return count;
  };
  EXPECT_EQ(rows(sizeof(double)), side);
  EXPECT_THAT(message_of([&] { rows(1 << 12); }), test::states("x", "far more memory"));
}

// Each by itself is within the bound.
TEST(hdf5_chunks, that_together_need_far_more_memory_than_the_file_has_bytes_are_refused) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "a.h5";
  write<double>(file, {side}, std::vector<double>(side));
  const auto reads = [&](int times) {
    read_results_of(kind, file, [&](const Hdf5Reader& root) {
      std::vector<double> values;
      Dims dims(1);
      for (int i = 0; i < times; ++i) root.array("x", {}, dims, values);
    });
  };
  reads(64);  // MiB
  EXPECT_THAT(message_of([&] { reads(200); }), test::states("x", "far more memory"));
}

// Letters of a byte each would become strings of 32.
TEST(hdf5_chunks, of_text_are_refused) {
  const auto text = [](hid_t file) {
    const hsize_t count = 60'000'000;
    const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
    set_chunks(creation, {{count}, 1});
    const hid_t space = H5Screate_simple(1, &count, nullptr);
    const Hdf5Handle type = text_type(1);
    const hid_t set = H5Dcreate2(file, "x", type, space, H5P_DEFAULT, creation, H5P_DEFAULT);
    const std::string letters(count, 'a');
    EXPECT_GE(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, letters.data()), 0);
    H5Dclose(set);
    H5Sclose(space);
  };
  const auto read_text = [](const std::filesystem::path& file) { read<std::string>(file, 1); };
  EXPECT_THAT(refusal(text, read_text), test::states("x", "chunks"));
}

struct Content {
  std::string text = "a";
  double number = 0.5;
  std::vector<double> small{1.0, 2.0}, large = std::vector<double>(side, 3.0);
  std::vector<std::string> texts{"b", "cd"};
  Dims dims{2, side / 2};
  const char* unit = "m";
  std::string group = "g";

  void operator()(const Hdf5Writer& root) const {
    root.attribute("text", text);
    root.attribute("number", number);
    const Hdf5Writer in = root.group(group);
    in.array("small", {unit, "values"}, {small.size()}, small);
    in.array("large", {"m", "values"}, dims, large);
    in.array("texts", {"-", "texts"}, {texts.size()}, texts);
  }
};

TEST(hdf5_content, that_is_compared_is_the_same_to_the_last_bit_or_named) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "a.h5";
  write_results_of(kind, file, Content());
  const auto difference = [&](auto change) -> std::string {
    const Hdf5Silence silence;
    Content other;
    change(other);
    try {
      other(Hdf5Writer::comparing(file));
    } catch (const Hdf5Error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(difference([](Content&) {}), "");
  EXPECT_THAT(difference([](Content& c) { c.text = "b"; }), test::states("text"));
  EXPECT_THAT(difference([](Content& c) { c.text = "aa"; }), test::states("text"));
  EXPECT_THAT(difference([](Content& c) { c.number = -0.5; }), test::states("number"));
  EXPECT_THAT(difference([](Content& c) { c.unit = "s"; }), test::states("unit"));
  EXPECT_THAT(difference([](Content& c) { c.small[1] = std::nextafter(2.0, 3.0); }),
              test::states("small"));
  EXPECT_THAT(difference([](Content& c) { c.small.push_back(3.0); }), test::states("small"));
  EXPECT_THAT(difference([](Content& c) { c.large.back() = -3.0; }), test::states("large"));
  EXPECT_THAT(difference([](Content& c) { std::ranges::reverse(c.dims); }), test::states("large"));
  EXPECT_THAT(difference([](Content& c) { c.texts[0] = "e"; }), test::states("texts"));
  EXPECT_THAT(difference([](Content& c) { c.group = "h"; }), test::states("h"));
}

}  // namespace
}  // namespace glissade
