// Independent tasks on several threads. Internal.
#pragma once

#include <functional>

#include "glare/base/progress.h"

namespace glare {

/// Calls `task(i)` once for each i in [0, count), on `threads` threads (0: as many as the machine
/// has). Tasks must not depend on one another; each is run whole by one thread, so a result that
/// depends only on `i` is the same for any number of threads. Exceptions of a task are passed on.
/// `progress` is told the share of tasks done; `Cancelled` is thrown when it says stop.
void parallel_for(int count, int threads, const std::function<void(int)>& task,
                  const ProgressCallback& progress = {});

}  // namespace glare
