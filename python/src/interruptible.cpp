#include "interruptible.h"

#include <atomic>
#include <chrono>
#include <exception>
#include <future>

namespace glare::python {

namespace py = pybind11;

namespace {

/// What the work and the one who waits tell one another.
struct Exchange {
  std::atomic<double> done = 0;
  std::atomic<bool> go_on = true;
  std::exception_ptr raised;  ///< By Python; only of the thread that waits, with the GIL.
};

/// Signals' handlers and the callable; with the GIL.
void heed(const py::object& progress, Exchange& exchange) {
  try {
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (progress.is_none()) return;
    const py::object answer = progress(exchange.done.load());
    if (answer.ptr() == Py_False) exchange.go_on = false;
  } catch (...) {
    exchange.raised = std::current_exception();
    exchange.go_on = false;
  }
}

void wait(std::future<void>& work, const py::object& progress, Exchange& exchange) {
  constexpr auto kBetweenLooks = std::chrono::milliseconds(50);
  const py::gil_scoped_release released;
  while (work.wait_for(kBetweenLooks) != std::future_status::ready) {
    if (!exchange.go_on) continue;
    const py::gil_scoped_acquire acquired;
    heed(progress, exchange);
  }
}

}  // namespace

void run_released(const py::object& progress,
                  const std::function<void(const ProgressCallback&)>& work) {
  Exchange exchange;
  const ProgressCallback note = [&exchange](double done) {
    exchange.done = done;
    return exchange.go_on.load();
  };
  std::future<void> result = std::async(std::launch::async, [&] { work(note); });
  wait(result, progress, exchange);
  if (exchange.raised) std::rethrow_exception(exchange.raised);
  result.get();
  if (!progress.is_none()) progress(1.0);
}

}  // namespace glare::python
