#include "cli/info/contents_text.hpp"
#include "cli/info/deployment_lines.hpp"
#include "cli/options/exit_code.hpp"
#include "cli/options/verbs.hpp"
#include "cli/ros2/learning_robot.hpp"
#include "cli/ros2/ros2_options.hpp"
#include "cli/terminal/live_view.hpp"
#include "cli/terminal/stop_signals.hpp"
#include "fleet/fleet_evidence.hpp"
#include "recording/ros_topics.hpp"
#include "ros2/robot_check.hpp"
#include "ros2/robot_node.hpp"
#include "session/session.hpp"

#include <opal/common/error.hpp>
#include <opal/deployment/deployment.hpp>
#include "localization/events/run_events.hpp"
#include "sensing/log_check.hpp"

#include <cstdlib>
#include <iostream>
#include <optional>

namespace opal::cli {
namespace {

/// What a page of a robot shows: it may run for months.
constexpr RecordWindow kPageWindow{.seconds = 600, .bytes = 32 << 20};

std::string environment_value(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

/// What is localized with, when the robot has told what its lasers are.
class RobotParts {
 public:
  RobotParts(const PluginRegistry& plugins, Deployment deployment, std::string config, EventSink* events,
             const LearningOptions& learning)
      : plugins_(plugins), deployment_(std::move(deployment)), config_(std::move(config)), events_(events) {
    check_parts(deployment_, plugins_);
    const std::string objection = learning.is_pushed ? objection_to_push(deployment_) : "";
    if (!objection.empty()) throw ConfigError(objection);
    const session::VersionedMap loaded = session::load_versioned_map(plugins_, deployment_);
    map_ = loaded.map;
    if (learning.any()) learning_.emplace(learning, plugins_, loaded);
    if (!takes_geometry_from_log(deployment_)) build_parts(deployment_, plugins_, map_);  // wrong options show now
  }

  const std::shared_ptr<const SemanticMap>& map() const { return map_; }
  /// Nobody listens if nothing is learned.
  ros2::RecordListener listener() {
    if (!learning_) return {};
    return [this](const LogRecord& record) { learning_->take(record); };
  }
  LocalizerParts make(std::span<const LogRecord> records) {
    Deployment fitted = deployment_;
    fitted.lasers = lasers_of_log(records, deployment_.lasers, "the robot", config_ + ": /sensor");
    LocalizerParts parts = build_parts(fitted, plugins_, map_);
    if (events_ != nullptr) begin_events(parts);
    if (learning_) learning_->begin(parts);
    return parts;
  }

 private:
  void begin_events(const LocalizerParts& parts) {
    if (!has_begun_) {
      events_->write(run_event({"a robot", config_, deployment_.map}, parts.lasers.front()));
      events_->write(map_event(*parts.map));
    }
    events_->write(start_event(std::exchange(has_begun_, true) ? "robot, with another laser" : "robot"));
  }

  const PluginRegistry& plugins_;
  Deployment deployment_;
  std::string config_;
  EventSink* events_;
  bool has_begun_ = false;
  std::shared_ptr<const SemanticMap> map_;
  std::optional<LearningRobot> learning_;
};

void tell_doubt(const Ros2Options& options, const Deployment& deployment) {
  if (const std::string doubt = options.sources_doubt(deployment); !doubt.empty())
    std::cerr << "ros2: " << doubt << '\n';
}

int localize_robot(const Ros2Options& options) {
  const Deployment deployment = options.deployment();
  tell_doubt(options, deployment);
  const PluginRegistry plugins = session::load_plugins(deployment);
  const StopSignals signals;  // before other threads
  std::optional<LiveView> page;
  if (options.serve) page.emplace(options.port, signals.token(), kPageWindow);
  EventSink* const events = page ? &page->events() : nullptr;
  RobotParts parts(plugins, deployment, options.config, events, options.learning);
  ros2::ServiceNotice notice(environment_value("NOTIFY_SOCKET"));
  const ros2::NodeOptions node_options = options.node(deployment);
  recording::expect_laser_each(node_options.read, deployment.lasers.size());
  std::cerr << "ros2: " << words_of(node_options.range) << '\n';
  ros2::RobotNode node(
      node_options, parts.map(), [&](auto records) { return parts.make(records); }, events, parts.listener());
  node.run(signals.token(), notice);
  return kDone;
}

int check_robot(const Ros2Options& options) {
  using recording::OdometryFirst;
  const StopSignals signals;
  const Deployment deployment = options.deployment_if_any();
  tell_doubt(options, deployment);
  const ros2::NodeOptions node = options.node(deployment);
  std::cerr << "looking for " << options.check_s << " s, " << words_of(node.range) << '\n';
  recording::TopicChoice choice = node.read;
  if (!options.names_scans(deployment)) choice.scans.clear();
  const auto first = choice.odometry.empty() ? OdometryFirst::transforms : OdometryFirst::topic;
  if (choice.odometry.empty()) choice.odometry = node.odometry_without_transforms;
  const ros2::RobotContents seen = look_at_robot(node.range, choice, first, options.check_s, signals.token());
  std::cout << contents_text(seen.contents) << '\n' << offers_text(seen.offers);
  const nlohmann::ordered_json lines = deployment_lines(seen.contents, "opal:McapLog");
  if (!seen.missing.empty()) std::cout << "\nmissing\n";
  for (const std::string& missing : seen.missing) std::cout << "  " << missing << '\n';
  if (!seen.doubts.empty()) std::cout << "\nto look at\n";
  for (const std::string& doubt : seen.doubts) std::cout << "  " << doubt << '\n';
  if (!lines.empty()) std::cout << "\nfor the deployment (-o FILE writes one)\n" << lines.dump(2) << '\n';
  if (!options.out.empty() && lines.empty())
    std::cerr << "ros2: no laser was heard, expected one for a deployment: " << options.out << " is not written\n";
  if (!options.out.empty() && !lines.empty()) write_deployment(lines, options.config, options.out);
  return seen.missing.empty() ? kDone : kNo;
}

}  // namespace

void add_ros2_verb(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<Ros2Options>();
  CLI::App* verb = app.add_subcommand("ros2", "localize a running robot as a node of ROS 2, without ROS installed");
  options->add_to(*verb);
  verb->callback(
      [options, &exit_code] { exit_code = options->check ? check_robot(*options) : localize_robot(*options); });
}

}  // namespace opal::cli
