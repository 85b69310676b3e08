// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace glissade {

/// How many threads, this one included and `most` at most, the system lets this process have now:
/// oneTBB throws where it cannot start one (limits on processes, address space).
int startable_threads(int most);

}  // namespace glissade
