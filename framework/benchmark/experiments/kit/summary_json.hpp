#pragma once

#include <nlohmann/json.hpp>

#include <vector>

namespace opal::experiments {

/// JSON knows no infinity: what never was is null.
nlohmann::ordered_json number_or_null(double value);

/// `runs`: how many of them something holds of; `within`: Wilson's 95 % interval of their share.
nlohmann::ordered_json share_json(int part, std::size_t whole);

/// `median` and `within`, its 95 % interval.
nlohmann::ordered_json median_json(const std::vector<double>& values);

}  // namespace opal::experiments
