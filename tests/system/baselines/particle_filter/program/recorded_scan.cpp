#include "recorded_scan.hpp"

#include <opal/common/error.hpp>

#include <zlib.h>
#include <sstream>

namespace {

/// FLASER n ranges... x y theta (laser) x y theta (robot) stamp host stamp
RecordedScan scan_of(const std::string& line, const std::string& where) {
  std::istringstream text(line);
  std::string kind;
  std::size_t count = 0;
  text >> kind >> count;
  RecordedScan scan;
  scan.ranges_m.resize(count);
  for (double& range_m : scan.ranges_m) text >> range_m;
  double x = 0, y = 0, theta = 0, robot = 0;
  text >> x >> y >> theta >> robot >> robot >> robot >> scan.stamp_s;
  if (!text)
    throw opal::LogError(where + ": cut off, expected FLASER with " + std::to_string(count) +
                         " ranges, two poses and a stamp");
  scan.T_odom_laser = opal::Pose2(x, y, theta);
  return scan;
}

}  // namespace

std::vector<RecordedScan> read_scans(const std::string& path) {
  const gzFile file = gzopen(path.c_str(), "rb");
  if (file == nullptr) throw opal::LogError(path + ": cannot be read");
  std::vector<RecordedScan> scans;
  std::vector<char> buffer(1 << 16);
  for (int number = 1; gzgets(file, buffer.data(), static_cast<int>(buffer.size())) != nullptr; ++number)
    if (const std::string line = buffer.data(); line.starts_with("FLASER"))
      scans.push_back(scan_of(line, path + ": line " + std::to_string(number)));
  gzclose(file);
  if (scans.empty()) throw opal::LogError(path + ": holds no FLASER line");
  return scans;
}
