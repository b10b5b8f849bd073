#pragma once

#include <string>

namespace opal {

/// How well something is that localization depends on.
struct HealthFinding {
  /// How much it matters.
  enum class Level {
    fine,      ///< as it should be
    doubtful,  ///< the answer may suffer
    bad        ///< there is no answer, or none to rely on
  };
  Level level = Level::fine;  ///< how much it matters
  std::string subject;        ///< "odometry", "clock", "map", "sensor description", or the name of a laser
  std::string words;          ///< what was found, with its number: "laser front: no scan for 2.3 s"
};

}  // namespace opal
