#pragma once

#include <algorithm>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace opal::experiments {

/// Names in order of appearance.
template <class Run>
std::vector<std::string> names(std::span<const Run> runs, std::string Run::*name) {
  std::vector<std::string> all;
  for (const Run& run : runs)
    if (std::find(all.begin(), all.end(), run.*name) == all.end()) all.push_back(run.*name);
  return all;
}

/// Those that satisfy something.
template <class Run, class Holds>
std::vector<const Run*> those(std::span<const Run> runs, const Holds& holds) {
  std::vector<const Run*> chosen;
  for (const Run& run : runs)
    if (holds(run)) chosen.push_back(&run);
  return chosen;
}

/// Those of a contender in one column of the thesis' table; in all if the column is "".
template <class Run>
std::vector<const Run*> those_of(std::span<const Run> runs, const std::string& contender, std::string Run::*column,
                                 const std::string& name = "") {
  return those(runs, [&](const Run& r) { return r.contender == contender && (name.empty() || r.*column == name); });
}

template <class Run, class Holds>
int count(const std::vector<const Run*>& runs, const Holds& holds) {
  return static_cast<int>(
      std::count_if(runs.begin(), runs.end(), [&](const Run* run) { return std::invoke(holds, *run); }));
}

template <class Run, class Value>
std::vector<double> values(const std::vector<const Run*>& runs, const Value& value) {
  std::vector<double> all;
  for (const Run* run : runs) all.push_back(static_cast<double>(std::invoke(value, *run)));
  return all;
}

inline std::string share_of(int part, std::size_t whole) { return std::to_string(part) + "/" + std::to_string(whole); }

}  // namespace opal::experiments
