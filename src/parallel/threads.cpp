// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/parallel/threads.hpp"

#include <algorithm>
#include <exception>
#include <future>
#include <thread>
#include <vector>

namespace glissade {

int startable_threads(int most) {
  std::promise<void> end;
  const std::shared_future<void> ended = end.get_future();
  std::vector<std::jthread> others;
  others.reserve(static_cast<std::size_t>(std::max(most, 1)));
  try {
    while (static_cast<int>(others.size()) + 1 < most)
      others.emplace_back([ended] { ended.wait(); });
  } catch (const std::exception&) {  // the system starts no more
  }
  end.set_value();
  return static_cast<int>(others.size()) + 1;
}

}  // namespace glissade
