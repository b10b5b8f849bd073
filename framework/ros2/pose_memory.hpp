#pragma once

#include <opal/common/geometry.hpp>

#include <optional>
#include <string>

namespace opal::ros2 {

/// The last pose of a localized robot, kept in a file from one run to the next.
class PoseMemory {
 public:
  /// @param path  empty: nothing is kept. @param map  the name of the map: a pose in another one is no pose here.
  /// @throws WriteError if the file could not be written.
  PoseMemory(std::string path, std::string map);

  /// @return nullopt if there is none of this map. A file that is damaged counts as none, which is said on stderr.
  std::optional<Pose2> recall() const;
  /// Keeps it, at most every two seconds. The file is whole at any time. If it cannot be written, this is said on
  /// stderr, and nothing is kept from then on. @param now_s  by any steady clock.
  void keep(const Pose2& T_map_base, double now_s);

 private:
  std::string path_, map_;
  double kept_s_ = -1e9;
};

}  // namespace opal::ros2
