#include "reports/run/side_by_side.hpp"

#include <algorithm>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace plumb::reports::run {

void side_by_side(std::size_t count, int workers, const std::function<void(std::size_t)>& work,
                  const std::function<bool()>& go_on) {
  std::mutex mutex;  // guards what follows
  std::size_t next = 0;
  std::exception_ptr failure;
  const auto work_off = [&] {
    for (;;) {
      std::size_t mine = 0;
      {
        const std::lock_guard lock(mutex);
        if (failure || next >= count || (go_on && !go_on())) return;
        mine = next++;
      }
      try {
        work(mine);
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (!failure) failure = std::current_exception();
      }
    }
  };
  {
    std::vector<std::jthread> others;
    const auto most = std::min<std::size_t>(count, std::max(workers, 1));
    for (std::size_t n = 1; n < most; ++n) others.emplace_back(work_off);
    work_off();
  }  // all have ended
  if (failure) std::rethrow_exception(failure);
}

}  // namespace plumb::reports::run
