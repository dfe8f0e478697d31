// Independent tasks on several threads. Internal.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include "glare/base/progress.h"

namespace glare {

/// The number of threads used when asked for `threads` (0: as many as the machine has): no more
/// than the machine has.
int threads_used(int threads);

/// Calls `task(i)` once for each i in [0, count), on `threads` threads (0: as many as the machine
/// has). Tasks must not depend on one another; each is run whole by one thread, so a result that
/// depends only on `i` is the same for any number of threads. Exceptions of a task are passed on.
/// `progress` is told the share of tasks done; `Cancelled` is thrown when it says stop.
void parallel_for(int count, int threads, const std::function<void(int)>& task,
                  const ProgressCallback& progress = {});

/// Working memory that tasks take and give back, so that there is one for each thread at most.
template <typename Workspace>
class WorkspacePool {
 public:
  /// One that no other task has; given back when the pointer goes.
  auto take() {
    const auto give_back = [this](Workspace* workspace) {
      const std::scoped_lock lock(mutex_);
      free_.emplace_back(workspace);
    };
    const std::scoped_lock lock(mutex_);
    if (free_.empty()) free_.push_back(std::make_unique<Workspace>());
    std::unique_ptr<Workspace, decltype(give_back)> taken(free_.back().release(), give_back);
    free_.pop_back();
    return taken;
  }

 private:
  std::mutex mutex_;
  std::vector<std::unique_ptr<Workspace>> free_;
};

}  // namespace glare
