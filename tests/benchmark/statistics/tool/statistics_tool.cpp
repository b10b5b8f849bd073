// Answers requests of compare_with_scipy.py: one JSON array per line, the name of a function and its arguments; one
// JSON value per line back.
#include "benchmark/statistics/alpha_spending.hpp"
#include "benchmark/statistics/cluster_bootstrap.hpp"
#include "benchmark/statistics/cluster_test.hpp"
#include "benchmark/statistics/holm.hpp"
#include "benchmark/statistics/mcnemar.hpp"
#include "benchmark/statistics/power.hpp"
#include "benchmark/statistics/sign_flip.hpp"
#include "benchmark/statistics/wilcoxon.hpp"

#include <nlohmann/json.hpp>

#include <functional>
#include <iostream>

namespace {

using namespace opal::statistics;
using nlohmann::json;
using Numbers = std::vector<double>;

PairedCounts counts(const json& in) { return {in[1], in[2], in[3], in[4]}; }
json ends(const Interval& interval) { return {interval.low, interval.high}; }

std::vector<ClusterSum> clusters(const json& sums, const json& pairs) {
  std::vector<ClusterSum> all;
  for (std::size_t i = 0; i < sums.size(); ++i) all.push_back({sums[i], pairs[i]});
  return all;
}

const std::map<std::string, std::function<json(const json&)>> kFunctions{
    {"mcnemar",
     [](const json& in) {
       const McNemar p = mcnemar(counts(in));
       return json{p.exact, p.mid};
     }},
    {"odds_ratio", [](const json& in) { return ends(matched_odds_ratio_interval(counts(in), in[5])); }},
    {"difference", [](const json& in) { return ends(difference_interval(counts(in), in[5])); }},
    {"wilcoxon",
     [](const json& in) {
       const Wilcoxon w = wilcoxon(in[1].get<Numbers>());
       return json{w.p, w.normal};
     }},
    {"holm", [](const json& in) { return json(holm(in[1].get<Numbers>())); }},
    {"t_test", [](const json& in) { return json(cluster_t_test(clusters(in[1], in[2]))); }},
    {"t_interval", [](const json& in) { return ends(cluster_t_interval(clusters(in[1], in[2]), in[3])); }},
    {"sign_flip", [](const json& in) { return json(sign_flip_test(in[1].get<Numbers>())); }},
    {"percentile", [](const json& in) { return ends(percentile_interval(in[1].get<Numbers>(), in[2])); }},
    {"power", [](const json& in) { return json(t_test_power(in[1], in[2], in[3])); }},
    {"units", [](const json& in) { return json(units_for_power(in[1], in[2], in[3])); }},
    {"looks", [](const json& in) { return json(look_levels(in[1], in[2].get<Numbers>())); }}};

}  // namespace

int main() {
  for (std::string line; std::getline(std::cin, line);) {
    const json request = json::parse(line);
    std::cout << kFunctions.at(request[0].get<std::string>())(request).dump() << '\n';
  }
}
