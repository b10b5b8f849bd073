#pragma once

#include <map>
#include <string>

namespace opal {

/// Calls into plugins in the middle of a run. What a plugin throws is counted and told once, and the run goes on
/// without that one contribution.
class PluginFailures {
 public:
  /// @return whether the call came back.
  template <class Call>
  bool guard(const std::string& plugin, Call&& call) {
    try {
      call();
      return true;
    } catch (const std::exception& error) {
      count(plugin, error.what());
    } catch (...) {
      count(plugin, "threw something that is no std::exception");
    }
    return false;
  }
  /// For a contribution that came back and is of no use.
  void count(const std::string& plugin, const std::string& cause);

  /// By the plugin's name.
  const std::map<std::string, int>& counts() const { return counts_; }

 private:
  std::map<std::string, int> counts_;
};

}  // namespace opal
