#include "evaluation/place_verdict.hpp"

#include <opal/common/quantile.hpp>

#include <algorithm>
#include <map>
#include <optional>
#include <sstream>

namespace opal {
namespace {

std::string after_text(const std::vector<double>& driven_m) {
  const auto median = median_of(driven_m);
  if (!median) return "";
  std::ostringstream text;
  text.precision(1);
  text << std::fixed << ", after " << *median << " m (median)";
  return text.str();
}

nlohmann::ordered_json json_of(const std::optional<double>& number) {
  return number ? nlohmann::ordered_json(*number) : nlohmann::ordered_json();
}

template <class T>
void append(std::vector<T>& all, const std::vector<T>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

void add(PlaceVerdict& place, const std::string& id, const QueryVerdict& query) {
  ++place.queries;
  place.strict += query.strict;
  if (query.success)
    place.right_after_m.push_back(*query.right_after_m);
  else
    place.failed.push_back(id);
  if (query.localized_after_m) place.localized_after_m.push_back(*query.localized_after_m);
  place.localized_rows += static_cast<std::size_t>(query.localized_rows);
  place.false_rows += static_cast<std::size_t>(query.false_rows);
  place.false_queries += !query.honest();
}

std::string failed_text(const std::vector<std::string>& failed) {
  constexpr std::size_t kNamed = 5;
  std::string text = "no success: ";
  for (std::size_t k = 0; k < std::min(kNamed, failed.size()); ++k) text += (k ? ", " : "") + failed[k];
  return failed.size() > kNamed ? text + " and " + std::to_string(failed.size() - kNamed) + " more" : text;
}

}  // namespace

void PlaceVerdict::add(const PlaceVerdict& other) {
  queries += other.queries;
  strict += other.strict;
  append(right_after_m, other.right_after_m);
  append(localized_after_m, other.localized_after_m);
  append(failed, other.failed);
  localized_rows += other.localized_rows;
  false_rows += other.false_rows;
  false_queries += other.false_queries;
}

PlaceVerdict judge_place(std::span<const ResultRow> rows, std::span<const Query> queries, const GroundTruth& truth) {
  std::map<std::string, std::vector<ResultRow>> by_query;
  for (const ResultRow& row : rows) by_query[row.query].push_back(row);
  PlaceVerdict place;
  for (const Query& query : queries) add(place, query.id, judge_query(by_query[query.id], query, truth));
  return place;
}

std::string summary_of(const PlaceVerdict& verdict) {
  std::ostringstream text;
  text << "success in " << verdict.success() << " of " << verdict.queries << " queries (strict: " << verdict.strict
       << ")" << after_text(verdict.right_after_m) << '\n'
       << "localized in " << verdict.localized_after_m.size() << " of " << verdict.queries << " queries"
       << after_text(verdict.localized_after_m) << '\n'
       << "wrongly localized: " << verdict.false_rows << " of " << verdict.localized_rows << " localized rows, in "
       << verdict.false_queries << (verdict.false_queries == 1 ? " query\n" : " queries\n");
  if (!verdict.failed.empty()) text << failed_text(verdict.failed) << '\n';
  return text.str();
}

nlohmann::ordered_json to_json(const PlaceVerdict& verdict) {
  return {{"success", verdict.success()},
          {"strict", verdict.strict},
          {"median_success_m", json_of(median_of(verdict.right_after_m))},
          {"localized", verdict.localized_after_m.size()},
          {"median_localized_m", json_of(median_of(verdict.localized_after_m))},
          {"localized_rows", verdict.localized_rows},
          {"false_rows", verdict.false_rows},
          {"false_queries", verdict.false_queries},
          {"failed", verdict.failed}};
}

}  // namespace opal
