#pragma once

#include <cstddef>
#include <functional>

namespace opal::experiments {

/// Does work 0 to count - 1 on some threads, begun in this order. What `work` writes must be its own.
/// Rethrows the first exception when all threads have ended; what had not begun is left undone.
void in_parallel(std::size_t count, int jobs, const std::function<void(std::size_t)>& work);

}  // namespace opal::experiments
