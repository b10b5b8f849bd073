#pragma once

#include "benchmark/experiments/kit/by_name.hpp"

#include <nlohmann/json.hpp>

#include <vector>

namespace opal::experiments {

/// JSON knows no infinity: what never was is null.
nlohmann::ordered_json number_or_null(double value);

/// `runs`: how many of them something holds of; `within`: Wilson's 95 % interval of their share.
nlohmann::ordered_json share_json(int part, std::size_t whole);

/// `median` and `within`, its 95 % interval.
nlohmann::ordered_json median_json(const std::vector<double>& values);

/// By contender, then of `all` and of each column of the thesis' table by itself.
/// @param summary_of  makes JSON of some runs and the name of their column, "" for all.
template <class Run, class SummaryOf>
nlohmann::ordered_json summary_by(std::span<const Run> runs, std::string Run::*column, const SummaryOf& summary_of) {
  nlohmann::ordered_json summary;
  for (const std::string& contender : names(runs, &Run::contender)) {
    summary[contender]["all"] = summary_of(those_of(runs, contender, column), "");
    for (const std::string& name : names(runs, column))
      summary[contender][name] = summary_of(those_of(runs, contender, column, name), name);
  }
  return summary;
}

}  // namespace opal::experiments
