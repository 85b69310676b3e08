// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "glissade/core/output_file.hpp"
#include "results/hdf5_handle.hpp"

namespace glissade {

/// An HDF5 file while it is written, through a driver of our own. libhdf5 never meets a write that
/// fails: it could lose data without an error, or crash. The first failure is kept here, nothing is
/// written after it, and throw_failure() reports it.
class Hdf5OutputFile {
 public:
  /// @param output empty, and open for reading too
  explicit Hdf5OutputFile(OutputFile& output);
  ~Hdf5OutputFile();
  Hdf5OutputFile(const Hdf5OutputFile&) = delete;
  Hdf5OutputFile& operator=(const Hdf5OutputFile&) = delete;

  hid_t root() const { return file_; }
  void throw_failure() const;
  void close();  ///< throws where anything was not written

  struct Target;

 private:
  std::shared_ptr<Target> target_;
  Hdf5Handle file_;
};

}  // namespace glissade
