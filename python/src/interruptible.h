// Long work that Python can go on beside, follow and stop.
#pragma once

#include <pybind11/pybind11.h>

#include <functional>

#include "glare/base/progress.h"

namespace glare::python {

/// Does the work on a thread of its own, without the GIL, and waits for it. Meanwhile this thread
/// tells `progress` (None, or a callable of the share done) what was done, every 50 ms and at the
/// end, and heeds signals. The work is stopped where the callable returns False, which gives
/// `Cancelled`, and where it or a signal's handler (Ctrl-C: KeyboardInterrupt) raises, which is
/// passed on. Python is only ever called by the thread that called this.
void run_released(const pybind11::object& progress,
                  const std::function<void(const ProgressCallback&)>& work);

}  // namespace glare::python
