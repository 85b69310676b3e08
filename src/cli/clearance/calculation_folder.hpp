// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "clearance/calculation_record.hpp"
#include "glissade/io/journal.hpp"
#include "glissade/parallel/communicator.hpp"

namespace glissade::cli {

struct ClearanceOptions {
  std::string project, out, resume;
  bool example = false, overwrite = false;
};

/// The folder of a calculation: what was begun there, and who writes there.
class CalculationFolder {
 public:
  /// @param page of its file: "package", "product"
  CalculationFolder(const ClearanceOptions& options, const Communicator& world, const char* page,
                    bool is_part = false)
      : options_(options), world_(world), page_(page), is_part_(is_part) {}

  /// Takes the folder on root; all ranks know its path. Throws ExitStatus 0 where --resume finds it
  /// whole, unless the calculation is part of another one.
  /// @param read on root, the project file: gives the names of its studies
  void begin(const std::function<std::vector<std::string>(const std::filesystem::path&)>& read);
  /// Runs a study of the folder: the file, NAME.toml, is written on root, and run on all ranks.
  void run(const std::string& name, const std::function<std::string()>& text) const;
  /// On root: what is made of the studies is written, then stated to be finished in run.json, and
  /// the folder given back.
  void finish(const std::function<void()>& write, const std::function<void()>& state);
  /// One that ended before, on root: refused, it gives back a folder that has nothing.
  void leave(int status) noexcept;

  const std::filesystem::path& path() const { return path_; }
  const CalculationIdentity& identity() const { return identity_; }

 private:
  bool is_whole() const;

  const ClearanceOptions& options_;
  const Communicator& world_;
  std::string page_;
  bool is_part_;
  std::filesystem::path path_;
  std::vector<std::string> studies_;  // on root, as the lock
  std::unique_ptr<RunLock> lock_;
  CalculationIdentity identity_;
};

/// A finished one: its page, and how to print it where it is not printed.
std::string page_text(const std::filesystem::path& folder, const std::string& page,
                      bool is_printed);

/// The studies of a project and its package; of several sites those of each, and their summary.
void run_calculation(const ClearanceOptions& options, const Communicator& world);
/// The studies of a product and its sheet.
void run_product(const ClearanceOptions& options, const Communicator& world);

}  // namespace glissade::cli
