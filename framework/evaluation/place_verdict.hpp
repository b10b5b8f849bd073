#pragma once

#include "evaluation/query_verdict.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace opal {

/// Did it work? What became of all queries of a recorded place. Distances are driven from the begin of a query [m].
struct PlaceVerdict {
  std::size_t queries = 0, strict = 0;
  std::vector<double> right_after_m;      ///< of the queries with success
  std::vector<double> localized_after_m;  ///< of the queries that were localized, and right
  std::vector<std::string> failed;        ///< queries without success
  std::size_t localized_rows = 0, false_rows = 0, false_queries = 0;

  std::size_t success() const { return right_after_m.size(); }
  /// Adds those of another place.
  OPAL_EXPORT void add(const PlaceVerdict& other);
};

/// @param rows  of all queries, each query's by increasing stamp.
OPAL_EXPORT PlaceVerdict judge_place(std::span<const ResultRow> rows, std::span<const Query> queries,
                                     const GroundTruth& truth);

/// For people: success first, then what was wrongly called localized, then the queries that failed. Several lines.
OPAL_EXPORT std::string summary_of(const PlaceVerdict& verdict);
/// The same numbers by name; a median of nothing is null.
OPAL_EXPORT nlohmann::ordered_json to_json(const PlaceVerdict& verdict);

}  // namespace opal
