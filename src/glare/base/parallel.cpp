#include "glare/base/parallel.h"

#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <mutex>

#include "glare/base/error.h"

namespace glare {

int threads_used(int threads) {
  const int most = tbb::info::default_concurrency();  // TBB warns on the error stream of more.
  return threads > 0 ? std::min(threads, most) : most;
}

void parallel_for(int count, int threads, const std::function<void(int)>& task,
                  const ProgressCallback& progress) {
  int done = 0;
  std::atomic<bool> stop{false};
  std::mutex progress_mutex;
  const auto run_one = [&](int i) {
    if (stop) return;
    task(i);
    if (!progress) return;
    const std::scoped_lock lock(progress_mutex);
    if (!stop && !progress(static_cast<double>(++done) / count)) stop = true;
  };
  tbb::task_arena arena(threads_used(threads));
  arena.execute([&] { tbb::parallel_for(0, count, 1, run_one, tbb::simple_partitioner{}); });
  if (stop) throw Cancelled();
}

}  // namespace glare
