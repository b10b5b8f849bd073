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

// What single stages make of such drives.
RunDigest samples_of_poor_records();
RunDigest samples_of_other_lasers();
RunDigest features_of_scans();
RunDigest local_map_of_a_drive();
RunDigest sensor_findings();
