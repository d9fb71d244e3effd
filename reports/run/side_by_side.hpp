#pragma once
#include <cstddef>
#include <functional>

namespace plumb::reports::run {

/// Calls work(0) .. work(count - 1), at most `workers` of them at a time (at least one), each as soon as a
/// worker is free. After the first exception, or once go_on() is false, no further one begins; those that run
/// are waited for, and the exception goes on to the caller. `work` must bear to be called from several
/// threads. An empty `go_on` is always true.
void side_by_side(std::size_t count, int workers, const std::function<void(std::size_t)>& work,
                  const std::function<bool()>& go_on = {});

}  // namespace plumb::reports::run
