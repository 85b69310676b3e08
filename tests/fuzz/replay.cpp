// SPDX-License-Identifier: GPL-3.0-or-later
// libFuzzer's place in builds without it: runs a target over the files and folders it is given, so
// that the corpus is tested by every compiler.
#include <algorithm>
#include <cstdio>
#include <vector>

#include "check.hpp"
#include "glissade/core/file.hpp"

int main(int argc, char** argv) {
  namespace fs = std::filesystem;
  std::vector<fs::path> files;
  for (const fs::path& path : std::vector<fs::path>(argv + 1, argv + argc)) {
    if (!fs::is_directory(path)) {
      files.push_back(path);
    } else {
      for (const auto& entry : fs::directory_iterator(path)) files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) {
    std::printf("%s\n", file.c_str());
    std::fflush(stdout);  // the last name printed is the one that failed
    const std::string bytes = glissade::read_text_file(file);
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  }
  std::printf("%zu inputs\n", files.size());
  return files.empty() ? 1 : 0;
}
