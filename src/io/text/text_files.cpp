// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/io/text_files.hpp"

#include <utility>

#include "glissade/core/bytes.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/file.hpp"
#include "glissade/core/input_file.hpp"

namespace glissade {

namespace fs = std::filesystem;

TextFile TextFile::read(const fs::path& file) { return {file, read_text_file(file)}; }

TextFiles::TextFiles(std::span<const char> packed) : are_given_(true) {
  std::vector<std::string> there;
  ByteReader in(packed);
  in.get(there);
  there_.insert(there.begin(), there.end());
  while (!in.at_end()) {
    std::string file, text;
    in.get(file).get(text);
    texts_.emplace(std::move(file), std::move(text));
  }
}

std::vector<char> TextFiles::packed() const {
  ByteWriter out;
  out.put(std::vector<std::string>(there_.begin(), there_.end()));
  for (const auto& [file, text] : texts_) out.put(file).put(text);
  return out.take();
}

TextFile TextFiles::text_file(const fs::path& folder, const std::string& name) {
  auto found = texts_.find(name);
  if (found == texts_.end()) {
    if (are_given_)
      throw InputError({name, "is not among the files that were read with the study", "", ""});
    found = texts_.emplace(name, read_text_file(folder / name)).first;
  }
  return {folder / name, found->second};
}

bool TextFiles::is_there(const fs::path& file) {
  if (!are_given_ && fs::exists(status_of(file))) there_.insert(file.string());
  return all_are_there_ || there_.contains(file.string());
}

}  // namespace glissade
