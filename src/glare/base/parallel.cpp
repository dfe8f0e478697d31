#include "glare/base/parallel.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <mutex>

#include "glare/base/error.h"

namespace glare {

void parallel_for(int count, int threads, const std::function<void(int)>& task,
                  const ProgressCallback& progress) {
  std::atomic<int> done{0};
  std::atomic<bool> stop{false};
  std::mutex progress_mutex;
  const auto run_one = [&](int i) {
    if (stop) return;
    task(i);
    const int now_done = ++done;
    if (!progress) return;
    const std::scoped_lock lock(progress_mutex);
    if (!stop && !progress(static_cast<double>(now_done) / count)) stop = true;
  };
  tbb::task_arena arena(threads > 0 ? threads : tbb::task_arena::automatic);
  arena.execute([&] {
    tbb::parallel_for(0, count, 1, run_one, tbb::simple_partitioner{});
  });
  if (stop) throw Cancelled();
}

}  // namespace glare
