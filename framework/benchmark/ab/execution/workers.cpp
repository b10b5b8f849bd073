#include "benchmark/ab/execution/workers.hpp"

#include "benchmark/ab/execution/child_process.hpp"
#include "benchmark/ab/execution/claim.hpp"

#include <opal/common/error.hpp>
#include "common/write_error.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <new>

namespace opal::ab {
namespace {

/// What the workers of one run share: a page of memory.
struct Shared {
  std::atomic<std::size_t> next_task{0}, done{0};
  std::atomic<bool> disk_failed{false};
};
static_assert(std::atomic<std::size_t>::is_always_lock_free, "processes share it");

class SharedPage {
 public:
  SharedPage() : page_(mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)) {
    if (page_ == MAP_FAILED) throw Error("no memory to share between workers");
    shared_ = new (page_) Shared;
  }
  ~SharedPage() { munmap(page_, sizeof(Shared)); }
  SharedPage(const SharedPage&) = delete;
  SharedPage& operator=(const SharedPage&) = delete;
  Shared& operator*() const { return *shared_; }

 private:
  void* page_;
  Shared* shared_ = nullptr;
};

/// What plugins print is kept apart from what the program says.
void print_into(const std::string& path) {
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0666);
  if (file < 0) throw WriteError(path, errno);
  dup2(file, STDERR_FILENO);
  dup2(file, STDOUT_FILENO);
  close(file);
}

/// The shard's work, seen by one of its processes.
class Worker {
 public:
  Worker(CellRunner& runner, const CellPlan& plan, const CellLimits& limits, const std::vector<bool>& finished,
         std::size_t end, Shared& shared, const std::string& journal)
      : runner_(runner),
        plan_(plan),
        limits_(limits),
        finished_(finished),
        end_(end),
        shared_(shared),
        journal_(journal) {}

  void work() {
    for (Block block = take(); block.first < block.end; block = take())
      for (std::size_t arm = 0; arm < plan_.arms(); ++arm)
        run_cells(runner_, plan_, arm, unfinished(block, arm), limits_, [&](const CellResult& result) {
          journal_.append(result);
          ++shared_.done;
        });
  }

 private:
  struct Block {
    std::size_t first, end;
  };
  Block take() {
    std::size_t first = shared_.next_task.load();
    for (;;) {
      if (first >= end_) return {end_, end_};
      const std::size_t end = plan_.end_of_block(first, end_);
      if (shared_.next_task.compare_exchange_weak(first, end)) return {first, end};
    }
  }
  std::vector<std::size_t> unfinished(const Block& block, std::size_t arm) const {
    std::vector<std::size_t> tasks;
    for (std::size_t task = block.first; task < block.end; ++task)
      if (!finished_[task * plan_.arms() + arm]) tasks.push_back(task);
    return tasks;
  }

  CellRunner& runner_;
  const CellPlan& plan_;
  const CellLimits& limits_;
  const std::vector<bool>& finished_;
  std::size_t end_;
  Shared& shared_;
  Journal journal_;
};

/// Waits until a process has come to its end. @throws Error with its failure.
bool has_ended(ChildProcess& child, const Shared& shared, double patience_s) {
  std::string ignored;
  if (child.hear(ignored, patience_s) != ChildProcess::Heard::end) return false;
  const std::string threw = "threw: ";
  const std::string& failure = child.failure();
  if (failure.starts_with(threw) && shared.disk_failed) throw WriteError(failure.substr(threw.size()));
  if (failure.starts_with(threw)) throw Error(failure.substr(threw.size()));
  if (!failure.empty()) throw Error("a worker " + failure);
  return true;
}

std::size_t count_finished(const std::vector<bool>& finished, std::size_t first, std::size_t end) {
  std::size_t count = 0;
  for (std::size_t k = first; k < end; ++k) count += finished[k];
  return count;
}

}  // namespace

void compute(CellRunner& runner, const CellPlan& plan, const ResultFolder& folder, const CellLimits& limits,
             const Shard& shard, std::size_t jobs, const std::function<void(const WorkProgress&)>& progress) {
  const std::size_t first = shard.first(plan.tasks()), end = shard.end(plan.tasks());
  Claim claim(folder.path(), first, end);
  const std::vector<bool> finished = finished_cells(folder, plan);
  WorkProgress made;
  made.all = (end - first) * plan.arms();
  made.before = count_finished(finished, first * plan.arms(), end * plan.arms());
  progress(made);
  if (made.before == made.all) return;

  const SharedPage page;
  Shared& shared = *page;
  shared.next_task = first;
  const auto start = std::chrono::steady_clock::now();
  std::vector<std::unique_ptr<ChildProcess>> workers;
  for (std::size_t k = 0; k < jobs; ++k)
    workers.push_back(std::make_unique<ChildProcess>([&, k](const ChildProcess::Say&) {
      claim.join();
      try {
        print_into(folder.log(shard, k));
        Worker(runner, plan, limits, finished, end, shared, folder.journal(shard, k)).work();
      } catch (const WriteError&) {
        shared.disk_failed = true;
        throw;
      }
    }));
  while (!workers.empty()) {
    std::erase_if(workers, [&](const auto& worker) { return has_ended(*worker, shared, 0.1); });
    made.done = shared.done;
    made.elapsed_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    progress(made);
  }
}

}  // namespace opal::ab
