// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "glissade/core/error.hpp"

namespace glissade {

/// What the system does not read or write: the disk fails, a right is missing, no more files can be
/// open. It says nothing of what a file holds: who leaves out files of other formats lets it pass.
class IoError : public InputError {
 public:
  IoError(Problem problem, int error_number)
      : InputError(std::move(problem)), error_number_(error_number) {}
  int error_number() const { return error_number_; }  ///< of the system: EIO, EACCES ...

 private:
  int error_number_;
};

/// The IoError of a file that cannot be written, and of one that cannot be read: the system's
/// reason and what to do.
[[noreturn]] void throw_io_error(const std::filesystem::path& path, const std::string& doing,
                                 int error_number);
[[noreturn]] void throw_read_error(const std::filesystem::path& path, const std::string& doing,
                                   int error_number);

}  // namespace glissade
