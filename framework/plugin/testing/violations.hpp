#pragma once

#include <exception>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace opal::testing {

/// Gathers broken promises as sentences: each rule at most once, for one example is enough to act on.
class Violations {
 public:
  /// @param subject  begins every sentence: "opal:LineDetector".
  explicit Violations(std::string subject) : subject_(std::move(subject)) {}

  /// @param rule  what was broken; a second sentence of the same rule is dropped.
  /// @param cause  what it usually is, for whoever has to mend it; empty: the sentence says it.
  void add(const std::string& rule, const std::string& sentence, const std::string& cause = "") {
    if (!rules_.insert(rule).second) return;
    sentences_.push_back(subject_ + " " + sentence + (cause.empty() ? "" : "; likely cause: " + cause));
  }

  /// Makes a call that must not throw.
  template <class Call>
  void expect_no_throw(const std::string& occasion, Call&& call) {
    try {
      std::forward<Call>(call)();
    } catch (const std::exception& error) {
      add("throws", "throws on " + occasion + ": " + error.what());
    } catch (...) {
      add("throws", "throws something that is no std::exception on " + occasion);
    }
  }

  bool empty() const { return sentences_.empty(); }
  std::vector<std::string> take() { return std::move(sentences_); }

 private:
  std::string subject_;
  std::set<std::string> rules_;
  std::vector<std::string> sentences_;
};

}  // namespace opal::testing
