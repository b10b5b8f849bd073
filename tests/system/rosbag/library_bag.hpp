#pragma once

#include <string>

/// Writes a bag with ROS 1's own library: 300 scans of 200 beams on /scan and as many poses on /odom, at 10 Hz from
/// 1000 s on. @param compression  "none", "bz2" or "lz4"
void write_library_bag(const std::string& path, const std::string& compression);
