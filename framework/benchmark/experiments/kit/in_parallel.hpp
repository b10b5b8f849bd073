#pragma once

#include <cstddef>
#include <functional>
#include <stop_token>

namespace opal::experiments {

/// Does work 0 to count - 1 on some threads, begun in this order. What `work` writes must be its own.
/// Rethrows the first exception when all threads have ended. What has not begun then, or when a stop is asked
/// for, is left undone.
void in_parallel(std::size_t count, int jobs, const std::function<void(std::size_t)>& work,
                 const std::stop_token& stop = {});

}  // namespace opal::experiments
