// SPDX-License-Identifier: GPL-3.0-or-later
#include "gnuplot.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <stdexcept>

#include "glissade/core/file.hpp"

namespace glissade::verification {

void gnuplot_svg(const std::filesystem::path& file, const std::string& script,
                 const std::string& size) {
  const std::filesystem::path script_file = std::filesystem::path(file).replace_extension(".gp");
  write_text_file(script_file, fmt::format("set terminal svg size {} font 'Helvetica,15' "
                                           "background '#ffffff'\nset output '{}'\n"
                                           "set grid lc rgb '#dddddd' lt 1 lw 0.7\n{}",
                                           size, file.string(), script));
  if (std::system(fmt::format("gnuplot '{}'", script_file.string()).c_str()) != 0)
    throw std::runtime_error("gnuplot failed on " + script_file.string());
  std::filesystem::remove(script_file);
}

}  // namespace glissade::verification
