// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hdf5.h>
#include <signal.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>
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

/// Keeps HDF5 from printing its own error stack while it lives. Where memory ends in libhdf5 it can
/// crash in its first calls, and end the process (exit) in any: both are reported, status 2.
class Hdf5Silence {
 public:
  Hdf5Silence() {
    ++alive_;
    static const bool has_begun = begin();
    static_cast<void>(has_begun);
    H5Eget_auto2(H5E_DEFAULT, &print_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~Hdf5Silence() {
    H5Eset_auto2(H5E_DEFAULT, print_, data_);
    --alive_;
  }
  Hdf5Silence(const Hdf5Silence&) = delete;
  Hdf5Silence& operator=(const Hdf5Silence&) = delete;

 private:
  static void end_without_memory() {
    constexpr std::string_view text = "glissade: there is not enough memory for this\n";
    static_cast<void>(!::write(STDERR_FILENO, text.data(), text.size()));
    ::_exit(2);
  }
  static bool begin() {
    std::atexit([] {
      if (alive_ > 0) end_without_memory();
    });
    struct sigaction report = {}, before = {};
    report.sa_handler = [](int) { end_without_memory(); };
    report.sa_flags = SA_ONSTACK;  // its error stack can call itself without end
    alignas(16) static char room[1 << 16];
    stack_t of_report = {}, stack_before = {};
    of_report.ss_sp = room;
    of_report.ss_size = sizeof room;
    ::sigaltstack(&of_report, &stack_before);
    ::sigaction(SIGSEGV, &report, &before);
    H5E_auto2_t print = nullptr;
    void* data = nullptr;
    H5dont_atexit();  // it crashes at the end of the process where it could not close a file
    const bool opened = H5open() >= 0 && H5Eget_auto2(H5E_DEFAULT, &print, &data) >= 0;
    ::sigaction(SIGSEGV, &before, nullptr);
    ::sigaltstack(&stack_before, nullptr);
    if (opened) return true;
    --alive_;
    throw std::bad_alloc();
  }

  static inline int alive_ = 0;
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
