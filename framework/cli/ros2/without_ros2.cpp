#include "cli/options/verbs.hpp"

#include <opal/common/error.hpp>

namespace opal::cli {

void add_ros2_verb(CLI::App& app, int&) {
  CLI::App* verb = app.add_subcommand("ros2", "localize a running robot as a node of ROS 2 (not in this build)");
  verb->allow_extras();
  verb->callback([] {
    throw Error(
        "ros2: this program was built without Cyclone DDS; install cyclonedds-dev and cyclonedds-tools, build again");
  });
}

}  // namespace opal::cli
