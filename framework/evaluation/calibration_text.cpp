#include "evaluation/calibration.hpp"

#include "report/quantity_text.hpp"

#include <fmt/format.h>

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

Table table_of(const Calibration& c) {
  Table table{{{"probability", "", false}, {"statements"}, {"clusters"}, {"said"}, {"came true"}, {"95 %"}}, {}};
  for (const ReliabilityBin& bin : c.bins)
    table.rows.push_back({interval_text(bin.from, bin.to, 3), std::to_string(bin.statements),
                          std::to_string(bin.clusters), fixed_text(bin.said, 4), fixed_text(bin.came_true, 4),
                          interval_text(bin.came_true_within.low, bin.came_true_within.high, 4)});
  return table;
}

std::string scores_of(const Calibration& c) {
  return fmt::format(
      "  Brier score {} = reliability {:.5f} - resolution {:.5f} + uncertainty {:.5f}, {:+.5f} within the bins\n"
      "  log loss {:.4f} nat ({}), expected calibration error {}\n",
      within_text(c.brier, c.brier_within.low, c.brier_within.high, 5), c.reliability, c.resolution, c.uncertainty,
      c.within_bins, c.log_loss, interval_text(c.log_loss_within.low, c.log_loss_within.high, 4),
      within_text(c.expected_error, c.expected_error_within.low, c.expected_error_within.high, 4));
}

}  // namespace opal
