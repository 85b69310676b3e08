// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hdf5.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

namespace glissade {

/// What HDF5 could not do; write_results and read_results turn it into an InputError.
class Hdf5Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The result of an HDF5 call, which is negative when it failed.
template <class T>
T checked(T result, const std::string& doing) {
  if (result < 0) throw Hdf5Error(doing);
  return result;
}

/// An HDF5 object that is closed at the end of its scope; close_now() where closing may write.
class Hdf5Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Hdf5Handle(hid_t id, Close how, const std::string& doing)
      : id_(checked(id, doing)), close_(how) {}
  Hdf5Handle(Hdf5Handle&& other) noexcept
      : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}
  Hdf5Handle(const Hdf5Handle&) = delete;
  Hdf5Handle& operator=(const Hdf5Handle&) = delete;
  Hdf5Handle& operator=(Hdf5Handle&&) = delete;
  ~Hdf5Handle() { close(); }
  operator hid_t() const { return id_; }
  /// Negative where libhdf5 could not.
  herr_t close() { return id_ < 0 ? 0 : close_(std::exchange(id_, H5I_INVALID_HID)); }
  void close_now(const std::string& doing) { checked(close(), doing); }

 private:
  hid_t id_;
  Close close_;
};

/// Creation properties without times.
inline Hdf5Handle timeless(hid_t property_class) {
  Hdf5Handle properties(H5Pcreate(property_class), H5Pclose, "make properties");
  checked(H5Pset_obj_track_times(properties, false), "leave times out");
  return properties;
}

/// Keeps HDF5 from printing its own error stack while it lives, and from crashing at the end of the
/// process when it could not close a file.
class Hdf5Silence {
 public:
  Hdf5Silence() {
    H5dont_atexit();
    H5Eget_auto2(H5E_DEFAULT, &print_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~Hdf5Silence() { H5Eset_auto2(H5E_DEFAULT, print_, data_); }
  Hdf5Silence(const Hdf5Silence&) = delete;
  Hdf5Silence& operator=(const Hdf5Silence&) = delete;

 private:
  H5E_auto2_t print_ = nullptr;
  void* data_ = nullptr;
};

/// Numbers as they are in memory, and as they are in the file: little-endian on every machine.
template <class T>
hid_t memory_type() {
  if constexpr (std::is_same_v<T, double>)
    return H5T_NATIVE_DOUBLE;
  else if constexpr (std::is_same_v<T, std::uint64_t>)
    return H5T_NATIVE_UINT64;
  else if constexpr (std::is_same_v<T, std::uint8_t>)
    return H5T_NATIVE_UINT8;
  else {
    static_assert(std::is_same_v<T, std::int32_t>);
    return H5T_NATIVE_INT32;
  }
}
template <class T>
hid_t file_type() {
  if constexpr (std::is_same_v<T, double>)
    return H5T_IEEE_F64LE;
  else if constexpr (std::is_same_v<T, std::uint64_t>)
    return H5T_STD_U64LE;
  else if constexpr (std::is_same_v<T, std::uint8_t>)
    return H5T_STD_U8LE;
  else {
    static_assert(std::is_same_v<T, std::int32_t>);
    return H5T_STD_I32LE;
  }
}

/// UTF-8 of a fixed number of bytes, padded with zeros.
inline Hdf5Handle text_type(std::size_t size) {
  Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "make a text type");
  checked(H5Tset_size(type, size == 0 ? 1 : size), "size a text type");
  checked(H5Tset_strpad(type, H5T_STR_NULLPAD), "pad a text type");
  checked(H5Tset_cset(type, H5T_CSET_UTF8), "set a text type to UTF-8");
  return type;
}

}  // namespace glissade
