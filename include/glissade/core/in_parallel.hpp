// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>

namespace glissade {

/// Calls work(i) for every i below `count`, on the threads of oneTBB; an exception ends it.
void in_parallel(std::size_t count, const std::function<void(std::size_t)>& work);

}  // namespace glissade
