#include "ros2/health_report.hpp"

#include "common/phrases.hpp"
#include "ros2/messages/diagnosis.hpp"

#include <ostream>

namespace opal::ros2 {
namespace {

constexpr double kComplainS = 5;
// How long others may take to be found before their absence is told.
constexpr double kSettleS = 2;

}  // namespace

HealthReport::HealthReport(std::ostream& out, double started_s)
    : out_(out), complained_s_(started_s + kSettleS - kComplainS) {}

void HealthReport::status(const LiveAnswer& answer) {
  if (answer.number == 0 || status_ == answer.estimate.status) return;
  status_ = answer.estimate.status;
  out_ << "ros2: " << status_words(answer) << std::endl;
}

void HealthReport::defects(const recording::Defects& defects) {
  for (const auto& [cause, times] : defects)
    if (defects_.insert(cause).second) out_ << "ros2: " << cause << std::endl;
}

void HealthReport::complaints(const std::vector<std::string>& words, double now_s) {
  const bool is_over = words.empty() && !complained_.empty();
  if ((words.empty() && !is_over) || now_s - complained_s_ < kComplainS) return;
  complained_s_ = now_s;
  complained_ = listed(words);
  out_ << "ros2: " << (is_over ? "all that is needed is received" : complained_) << std::endl;
}

}  // namespace opal::ros2
