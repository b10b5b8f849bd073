#include "cli/ros2/learning_robot.hpp"

#include "common/text_file.hpp"
#include "common/utc_time.hpp"
#include "fleet/fleet_evidence.hpp"

#include <opal/common/error.hpp>

#include <unistd.h>

#include <array>
#include <iostream>

namespace opal::cli {
namespace {

std::string host_name() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "a robot";
}

}  // namespace

LearningRobot::LearningRobot(const LearningOptions& options, const PluginRegistry& plugins,
                             const session::VersionedMap& map)
    : options_(options) {
  if (!options.is_pushed) return;
  store_ = session::map_store(plugins);
  version_ = map.version.value();
  outbox_ = EvidenceOutbox::usual();
}

LearningRobot::~LearningRobot() { ends_ = true; }

void LearningRobot::begin(const LocalizerParts& parts) {
  observer_ = std::make_unique<LiveObserver>(parts, host_name() + " " + now_utc(),
                                             [this](const DriveEvidence& evidence) { keep(evidence); });
}

void LearningRobot::take(const LogRecord& record) {
  if (observer_) observer_->take(record);
}

void LearningRobot::keep(const DriveEvidence& evidence) {
  const nlohmann::ordered_json document = to_json(evidence);
  try {
    if (!options_.evidence.empty()) {
      said_.push_back(document);
      write_text(options_.evidence, said_.dump(1) + '\n');
    }
    if (outbox_) outbox_->keep(store_->where(), version_, document.dump());
  } catch (const Error& error) {
    std::cerr << "ros2: " << error.what() << ": what this visit has taught is lost\n";
  }
  if (store_ && !ends_) send();
}

void LearningRobot::send() {
  try {
    for (const std::string& refusal : send_waiting(*store_, *outbox_).refused)
      std::cerr << "ros2: not pushed: " << refusal << '\n';
  } catch (const Error& error) {  // it waits
    std::cerr << "ros2: not pushed yet: " << error.what() << '\n';
  }
}

}  // namespace opal::cli
