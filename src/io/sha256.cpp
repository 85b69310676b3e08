// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/io/sha256.hpp"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <array>

#include "glissade/core/contract.hpp"
#include "glissade/core/file.hpp"

namespace glissade {

std::string sha256_of_file(const std::filesystem::path& file) {
  return sha256_of(read_text_file(file));
}

std::string sha256_of(std::string_view bytes) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int size = 0;
  [[maybe_unused]] const int done =  // where contracts are off
      EVP_Digest(bytes.data(), bytes.size(), digest.data(), &size, EVP_sha256(), nullptr);
  GLISSADE_EXPECTS(done == 1);
  std::string text;
  for (unsigned int i = 0; i < size; ++i) text += fmt::format("{:02x}", digest[i]);
  return text;
}

}  // namespace glissade
