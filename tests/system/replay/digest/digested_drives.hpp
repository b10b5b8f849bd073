#pragma once

#include "run_digest.hpp"

#include <string>
#include <vector>

/// Short drives, each for other branches of the localizer, and all that is said of them.
struct DigestedDrive {
  std::string name;
  RunDigest (*run)();
};

const std::vector<DigestedDrive>& digested_drives();
