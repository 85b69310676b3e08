// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/hdf5_output_file.hpp"

#if H5_VERSION_GE(1, 13, 0)
#include <H5FDdevelop.h>
#endif

#include <algorithm>
#include <exception>
#include <limits>
#include <new>
#include <span>
#include <string_view>

namespace glissade {

/// Where the driver writes. Shared with libhdf5, which may keep a file open that it cannot close.
struct Hdf5OutputFile::Target {
  OutputFile* output;  ///< null once it is gone
  std::exception_ptr failure;

  /// Keeps the first failure.
  template <class What>
  void try_to(What what) noexcept {
    try {
      if (output != nullptr) what(*output);
    } catch (...) {
      if (!failure) failure = std::current_exception();
    }
  }
  template <class What>
  void write(What what) noexcept {
    if (!failure) try_to(what);
  }
};

namespace {

using Target = Hdf5OutputFile::Target;

/// A file as libhdf5 knows it.
struct DriverFile : H5FD_t {
  std::shared_ptr<Target> target;
  haddr_t end_of_space = 0, end_of_file = 0;
};
DriverFile& of(H5FD_t* file) { return *static_cast<DriverFile*>(file); }
const DriverFile& of(const H5FD_t* file) { return *static_cast<const DriverFile*>(file); }

/// What the access properties of a file hold for the driver.
struct DriverInfo {
  const std::shared_ptr<Target>* target;
};

H5FD_t* open_driver(const char*, unsigned, hid_t access, haddr_t) {
  const auto* info = static_cast<const DriverInfo*>(H5Pget_driver_info(access));
  DriverFile* file = info == nullptr ? nullptr : new (std::nothrow) DriverFile{};
  if (file != nullptr) file->target = *info->target;
  return file;
}
herr_t close_driver(H5FD_t* file) {
  delete &of(file);
  return 0;
}
/// As libhdf5's own driver of files, so that the layout of the file is the same.
herr_t query_driver(const H5FD_t*, unsigned long* flags) {
  *flags = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA | H5FD_FEAT_DATA_SIEVE |
           H5FD_FEAT_AGGREGATE_SMALLDATA | H5FD_FEAT_DEFAULT_VFD_COMPATIBLE;
  return 0;
}
haddr_t end_of_space(const H5FD_t* file, H5FD_mem_t) { return of(file).end_of_space; }
herr_t set_end_of_space(H5FD_t* file, H5FD_mem_t, haddr_t end) {
  of(file).end_of_space = end;
  return 0;
}
haddr_t end_of_file(const H5FD_t* file, H5FD_mem_t) { return of(file).end_of_file; }
/// libhdf5 may read what it has written: zeros where a failure kept it from being written.
herr_t read_driver(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t at, std::size_t size, void* into) {
  const std::span bytes(static_cast<char*>(into), size);
  std::ranges::fill(bytes, '\0');
  of(file).target->try_to([&](const OutputFile& output) { output.read_at(at, bytes); });
  return 0;
}
herr_t write_driver(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t at, std::size_t size,
                    const void* from) {
  const std::string_view bytes(static_cast<const char*>(from), size);
  of(file).target->write([&](OutputFile& output) { output.write_at(at, bytes); });
  of(file).end_of_file = std::max(of(file).end_of_file, at + size);
  return 0;
}
herr_t truncate_driver(H5FD_t* file, hid_t, hbool_t) {
  DriverFile& f = of(file);
  if (f.end_of_file != f.end_of_space)
    f.target->write([&](OutputFile& output) { output.resize(f.end_of_space); });
  f.end_of_file = f.end_of_space;
  return 0;
}

/// Registered once; libhdf5 has it until the process ends.
hid_t driver() {
  static const H5FD_class_t driver_class = [] {
    H5FD_class_t c{};
#if H5_VERSION_GE(1, 13, 0)
    c.version = H5FD_CLASS_VERSION;
    c.value = static_cast<H5FD_class_value_t>(511);  // 256 to 511 are for tests and private drivers
#endif
    c.name = "glissade";
    c.maxaddr = static_cast<haddr_t>(std::numeric_limits<std::int64_t>::max());
    c.fc_degree = H5F_CLOSE_STRONG;
    c.fapl_size = sizeof(DriverInfo);
    c.open = open_driver;
    c.close = close_driver;
    c.query = query_driver;
    c.get_eoa = end_of_space;
    c.set_eoa = set_end_of_space;
    c.get_eof = end_of_file;
    c.read = read_driver;
    c.write = write_driver;
    c.truncate = truncate_driver;
    constexpr H5FD_mem_t kinds[H5FD_MEM_NTYPES] = H5FD_FLMAP_DICHOTOMY;
    std::ranges::copy(kinds, c.fl_map);
    return c;
  }();
  static const hid_t id = checked(H5FDregister(&driver_class), "register the driver");
  return id;
}

Hdf5Handle create(const std::shared_ptr<Target>& target) {
  const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "make properties");
  const DriverInfo info{&target};
  checked(H5Pset_driver(access, driver(), &info), "take the driver");
  // Nobody else knows the file, and some shared file systems cannot lock.
  checked(H5Pset_file_locking(access, false, true), "leave locks out");
  checked(H5Pset_libver_bounds(access, H5F_LIBVER_EARLIEST, H5F_LIBVER_V18), "fix the format");
  const Hdf5Handle creation = timeless(H5P_FILE_CREATE);
  // Gives the root group the newer object header, whose attributes may be longer than 64 KiB (the
  // study file).
  checked(H5Pset_attr_creation_order(creation, H5P_CRT_ORDER_TRACKED),
          "keep the order of attributes");
  return {H5Fcreate("results", H5F_ACC_TRUNC, creation, access), H5Fclose, "begin the file"};
}

}  // namespace

Hdf5OutputFile::Hdf5OutputFile(OutputFile& output)
    : target_(std::make_shared<Target>(&output)), file_(create(target_)) {}

Hdf5OutputFile::~Hdf5OutputFile() {
  file_.close();
  target_->output = nullptr;
}

void Hdf5OutputFile::throw_failure() const {
  if (target_->failure) std::rethrow_exception(target_->failure);
}

void Hdf5OutputFile::close() {
  file_.close_now("close the file");
  throw_failure();
}

}  // namespace glissade
