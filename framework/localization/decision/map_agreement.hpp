#pragma once

#include <opal/localization/observation/observation.hpp>
#include <opal/map/view/map_view.hpp>

#include <optional>

namespace opal {

/// Shares of the returns on which a map has a say. All others ended before they reached anything mapped.
struct MapAgreement {
  double met = 0;     ///< they end on a mapped surface
  double passed = 0;  ///< they pass through one

  /// Of these the share that agrees; 1 if the map has no say.
  double share() const { return met + passed > 0 ? met / (met + passed) : 1; }
};

/// What the map says of the scans if the robot is at a pose. Scorers have no part in it: whatever scorer runs, a
/// pose is called localized by the same rule.
OPAL_EXPORT MapAgreement agreement(const Observation& observation, const MapView& map, const Pose2& T_map_base);

/// Of one scan: looked at once for a pose.
class OPAL_EXPORT ScanAgreement {
 public:
  const MapAgreement& at(const Pose2& T_map_base, const Observation& observation, const MapView& map);
  /// Another scan comes.
  void clear() { seen_.reset(); }

 private:
  struct Seen {
    Pose2 T_map_base;
    MapAgreement agreement;
  };
  std::optional<Seen> seen_;
};

/// Mean of the newest agreements, where a whole piece of evidence counts more than a part of one.
class OPAL_EXPORT MeanAgreement {
 public:
  /// @param memory  share that is kept per whole piece of evidence.
  explicit MeanAgreement(double memory = 0.8) : memory_(memory) {}

  /// @param tempering_weight  how much of a new piece of evidence the scan was, in (0, 1].
  void add(const MapAgreement& scan, double tempering_weight);
  void clear() { sum_ = {}; }
  double share() const { return sum_.share(); }

 private:
  double memory_;
  MapAgreement sum_;
};

/// Tells when the share that agrees falls from one scan to the next by far more than it usually changes on this map.
/// Who drives into a part that the map has wrong sees it come; who is kidnapped does not.
class OPAL_EXPORT AgreementFall {
 public:
  /// @return the share fell with this scan.
  bool add(const MapAgreement& scan);
  void clear() { *this = {}; }

 private:
  double share_ = 0;           ///< of the scan before
  double usual_change_ = 0.1;  ///< mean, either way, over the newest scans; a sound map has less
};

}  // namespace opal
