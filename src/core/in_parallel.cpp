// SPDX-License-Identifier: GPL-3.0-or-later
// The preset tsan compiles this source without the thread sanitizer: that cannot see how oneTBB,
// which is not compiled with it, orders its threads, so the order is stated here.
#include "glissade/core/in_parallel.hpp"

#include <tbb/parallel_for.h>

#ifdef GLISSADE_THREAD_SANITIZER
#include <sanitizer/tsan_interface.h>
#else
#define __tsan_acquire(address)
#define __tsan_release(address)
#endif

namespace glissade {

void in_parallel(std::size_t count, const std::function<void(std::size_t)>& work) {
  [[maybe_unused]] char begin = 0, end = 0;
  __tsan_release(&begin);
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
    __tsan_acquire(&begin);
    work(i);
    __tsan_release(&end);
  });
  __tsan_acquire(&end);
}

}  // namespace glissade
