#include "evaluation/calibration.hpp"

#include <opal/common/sentence.hpp>

namespace opal {
namespace {

nlohmann::ordered_json json_of(const Interval& interval) {
  return nlohmann::ordered_json::array({interval.low, interval.high});
}

}  // namespace

nlohmann::ordered_json to_json(const Calibration& c) {
  nlohmann::ordered_json bins = nlohmann::ordered_json::array();
  for (const ReliabilityBin& bin : c.bins)
    bins.push_back({{"from", bin.from},
                    {"to", bin.to},
                    {"statements", bin.statements},
                    {"clusters", bin.clusters},
                    {"said", bin.said},
                    {"came_true", bin.came_true},
                    {"came_true_95", json_of(bin.came_true_within)}});
  return {{"statements", c.statements},
          {"clusters", c.clusters},
          {"came_true", c.came_true},
          {"brier", c.brier},
          {"brier_95", json_of(c.brier_within)},
          {"reliability", c.reliability},
          {"resolution", c.resolution},
          {"uncertainty", c.uncertainty},
          {"within_bins", c.within_bins},
          {"log_loss", c.log_loss},
          {"log_loss_95", json_of(c.log_loss_within)},
          {"expected_error", c.expected_error},
          {"expected_error_95", json_of(c.expected_error_within)},
          {"bins", std::move(bins)}};
}

std::string table_of(const Calibration& c) {
  std::string table = "     probability   statements  clusters     said  came true   95 %\n";
  for (const ReliabilityBin& bin : c.bins)
    table += sentence("  %.3f to %.3f   %10zu  %8zu   %.4f     %.4f   %.4f to %.4f\n", bin.from, bin.to, bin.statements,
                      bin.clusters, bin.said, bin.came_true, bin.came_true_within.low, bin.came_true_within.high);
  return table;
}

std::string scores_of(const Calibration& c) {
  return sentence("  Brier score %.5f (%.5f to %.5f) = reliability %.5f - resolution %.5f + uncertainty %.5f %+.5f\n",
                  c.brier, c.brier_within.low, c.brier_within.high, c.reliability, c.resolution, c.uncertainty,
                  c.within_bins) +
         sentence("  log loss %.4f nat (%.4f to %.4f), expected calibration error %.4f (%.4f to %.4f)\n", c.log_loss,
                  c.log_loss_within.low, c.log_loss_within.high, c.expected_error, c.expected_error_within.low,
                  c.expected_error_within.high);
}

}  // namespace opal
