#pragma once

#include "navigation/localization_queries.hpp"

#include <memory>
#include <string>

namespace opal::remote {

struct RemoteOptions {
  double timeout_s =
      2;  ///< for an answer to a scan; then localization counts as away, and is asked again at the next one
  double begin_s = 60;  ///< for the map, and for the beginning of a drive: a large map takes time
};

/// Localization that is another program (localization_server.hpp). When it does not answer, or with something
/// that cannot be understood, `answers()` is false and `trouble()` says why; when it comes back, the drive
/// goes on, if need be as one that has just begun.
class RemoteLocalization : public navigation::Localization {
 public:
  /// Gets the map. @param address  HOST:PORT.
  /// @throws Error naming the address if nobody answers, if it speaks another version, or the map cannot be
  /// used.
  RemoteLocalization(const std::string& address, const LaserModel& laser, const RemoteOptions& options = {});
  ~RemoteLocalization() override;

  /// @throws Error if localization is not there.
  void begin() override;
  /// @throws Error if another robot has begun a drive there, or the scan was refused as such.
  void take(const RawScan& scan) override;
  /// Is said with the next scan, and those after it until one is answered.
  void keep_pattern() override;

  bool answers() const override;
  const std::string& trouble() const;  ///< empty if there is none

  PoseEstimate estimate() const override;
  const Scan& newest_scan() const override;
  const Pose2& T_odom_base() const override;
  const LaserModel& laser() const override;
  std::vector<Geometry> pattern() const override;
  const MapView& map() const override;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace opal::remote
