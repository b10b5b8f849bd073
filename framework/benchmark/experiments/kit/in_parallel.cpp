#include "benchmark/experiments/kit/in_parallel.hpp"

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace opal::experiments {

void in_parallel(std::size_t count, int jobs, const std::function<void(std::size_t)>& work,
                 const std::stop_token& stop) {
  std::atomic<std::size_t> next = 0;
  std::exception_ptr failure;
  std::mutex failing;
  const auto keep_working = [&] {
    for (std::size_t k = next++; k < count && !stop.stop_requested(); k = next++) try {
        work(k);
      } catch (...) {
        next = count;
        const std::lock_guard lock(failing);
        if (!failure) failure = std::current_exception();
      }
  };
  std::vector<std::thread> others;
  for (int k = 1; k < jobs; ++k) others.emplace_back(keep_working);
  keep_working();
  for (std::thread& other : others) other.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace opal::experiments
