// embed DEPLOYMENT MAP LOG: the localizer in a program of one's own. Replays a log, and prints every answer.
#include <opal/common/error.hpp>
#include <opal/deployment/deployment.hpp>
#include <opal/plugin/plugin_folders.hpp>
#include <opal/sensing/replay.hpp>

#include <cstdio>

/// What is described beside libopal.so. A plugin is opened when something of it is needed.
opal::PluginRegistry plugins() {
  opal::PluginRegistry registry;
  for (const std::string& folder : opal::plugin_folders())
    for (const std::string& refusal : registry.announce_all(folder)) std::fprintf(stderr, "%s\n", refusal.c_str());
  return registry;
}

void print(const opal::PoseEstimate& answer) {
  std::printf("%.2f s: %s", answer.stamp_s, opal::name_of(answer.status));
  const opal::Pose2& pose = answer.T_map_base;
  const double heading_deg = opal::degrees(pose.heading_rad());
  if (answer.has_pose) std::printf(", x %.2f m, y %.2f m, heading %.1f deg", pose.x(), pose.y(), heading_deg);
  std::printf("\n");
}

int main(int argc, char** argv) try {
  if (argc != 4) throw opal::Error("usage: embed DEPLOYMENT MAP LOG");
  const opal::PluginRegistry registry = plugins();
  const opal::Deployment deployment = opal::read_deployment(argv[1]);
  opal::Localizer localizer(opal::build_parts(deployment, registry, opal::SemanticMap::read(argv[2])));

  // On a robot, a driver stands here: it gives a scan and the odometry at the scan's stamp.
  opal::Replay replay(registry.make<opal::LogSource>("opal:CarmenLog")->open(argv[3]), deployment.lasers);
  while (const auto sample = replay.next())
    if (const auto answer = localizer.update(*sample)) print(*answer);  // none: no keyframe
} catch (const opal::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
