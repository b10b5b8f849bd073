#include "plugin/testing/scorer_memory_laws.hpp"

#include <cmath>
#include <optional>
#include <typeinfo>

namespace opal::testing {
namespace {

using Memory = std::unique_ptr<ScorerMemory>;

class MemoryTrial {
 public:
  MemoryTrial(const MemoryQuestion& question, Violations& violations) : ask_(question), violations_(violations) {}

  void run() {
    const Memory memory = new_memory();
    if ((memory == nullptr) != (new_memory() == nullptr))
      return violations_.add("memory is steady", "makes a new memory of a map at one time and none at another");
    if (!memory) return check_without();
    check_reading(*memory);
    check_copy(*memory);
    check_growth(*memory);
    check_copy(*memory);  // of a hypothesis that has met something
  }

 private:
  Memory new_memory() {
    Memory made;
    violations_.expect_no_throw("making a new memory", [&] { made = ask_.scorer.new_memory(ask_.view); });
    return made;
  }

  std::optional<Score> score(const ScorerMemory* memory) {
    std::optional<Score> score;
    violations_.expect_no_throw(ask_.name + " with its memory",
                                [&] { score = ask_.scorer.score(ask_.hypothesis, ask_.seen, ask_.view, memory); });
    return score;
  }

  /// What the framework does with a scan that counts.
  void live_on(ScorerMemory& memory, double weight) {
    const auto now = score(&memory);
    violations_.expect_no_throw("fading the memory of " + ask_.name, [&] { ask_.scorer.fade(memory, weight); });
    if (!now || !now->seen) return;
    violations_.expect_no_throw("remembering a scan of " + ask_.name,
                                [&] { ask_.scorer.remember(memory, *now->seen, weight); });
  }

  void expect_same(const std::optional<Score>& a, const std::optional<Score>& b, const std::string& rule,
                   const std::string& sentence) {
    if (!a || !b || !std::isfinite(a->log_likelihood)) return;  // told elsewhere
    if (!same_score(*a, *b)) violations_.add(rule, sentence);
  }

  void check_without() {
    const auto now = score(nullptr);
    if (now && now->seen)
      violations_.add("memory is missing",
                      "says what it has seen of " + ask_.name + ", but makes no new memory to remember it in");
  }

  void check_reading(const ScorerMemory& memory) {
    const auto once = score(&memory);
    expect_same(once, score(&memory), "memory is read only",
                "gives " + ask_.name + " another score when the same memory is used again");
  }

  void check_copy(const ScorerMemory& memory) {
    Memory copy;
    violations_.expect_no_throw("copying the memory of " + ask_.name, [&] { copy = memory.copy(); });
    const ScorerMemory* copied = copy.get();
    if (!copied || typeid(*copied) != typeid(memory))
      return violations_.add("memory copies itself",
                             "has a memory whose copy is " + std::string(copy ? "of another type" : "null"));
    const auto before = score(&memory);
    expect_same(before, score(copy.get()), "memory copy is equal",
                "gives " + ask_.name + " another score with a copy of its memory");
    live_on(*copy, 1);
    expect_same(before, score(&memory), "memory copy is independent",
                "gives " + ask_.name + " another score after a copy of its memory has remembered a scan and faded");
  }

  void check_growth(ScorerMemory& memory) {
    constexpr int kScans = 10;
    for (const double weight : {1.0, 0.5, 1e-6})
      for (int scan = 0; scan < kScans; ++scan) live_on(memory, weight);
    const auto now = score(&memory);
    if (now && !std::isfinite(now->log_likelihood))
      violations_.add("memory stays finite", "gives " + ask_.name + " a score of " +
                                                 std::to_string(now->log_likelihood) +
                                                 " after it has remembered some scans");
  }

  const MemoryQuestion& ask_;
  Violations& violations_;
};

}  // namespace

bool same_score(const Score& a, const Score& b) {
  return a.log_likelihood == b.log_likelihood && a.veto == b.veto && a.breakdown.size() == b.breakdown.size();
}

void check_memory(const MemoryQuestion& question, Violations& violations) { MemoryTrial(question, violations).run(); }

}  // namespace opal::testing
