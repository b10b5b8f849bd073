#pragma once

#include <opal/common/error.hpp>
#include <opal/common/geometry.hpp>
#include <opal/map/semantic_map.hpp>

#include <optional>
#include <string>
#include <vector>

namespace opal {

/// A map store refuses, or cannot do, what it was asked. The message holds no secret.
class OPAL_EXPORT StoreError : public Error {
 public:
  using Error::Error;
  ~StoreError() override;
};

/// The store cannot be reached, or went away in the middle: whoever has a copy can go on with it.
class OPAL_EXPORT StoreUnreachable : public StoreError {
 public:
  using StoreError::StoreError;
  ~StoreUnreachable() override;
};

/// The newest version is another one than the pusher expected: look at it first.
class OPAL_EXPORT StoreConflict : public StoreError {
 public:
  using StoreError::StoreError;
  ~StoreConflict() override;
};

/// One version of a building's map, as the store lists it. A version never changes once it is there.
struct StoredVersion {
  std::string building;   ///< name of the building in this store
  int version = 0;        ///< 1, 2, ... per building; a number is never given twice
  std::string pushed_at;  ///< UTC, by the store's clock: "2026-11-21T14:02:11Z"
  std::string pushed_by;  ///< the role that pushed it
  std::string message;    ///< what the pusher said about it; may be empty
  std::string map_name;   ///< SemanticMap::name()
  int objects = 0,        ///< number in the map
      features = 0,       ///< number in the map, all sensors
      patterns = 0;       ///< number that the map itself names
};

/// A version with its map, as the text of a JSON-LD document that SemanticMap::parse reads. It is the graph that was
/// pushed; its layout is the store's.
struct StoredMap {
  StoredVersion version;  ///< which one it is
  std::string document;   ///< JSON-LD, UTF-8
};

/// What a pusher says beside the map.
struct MapPush {
  std::string building;      ///< name of the building; a new name makes a new building
  std::string message = {};  ///< for people; may be empty
  /// The newest version that the pusher knows of, 0 for none: another one is a StoreConflict.
  std::optional<int> expected_version = {};
};

/// "Which features can `sensor` perceive within radius_m of `center`?" Frame: `map`.
struct NearQuery {
  std::string building;          ///< name of the building in this store
  int version = 0;               ///< 0: the newest
  std::string sensor;            ///< id of the sensor: "PlanarLidar2D"
  Point center = Point::Zero();  ///< [m], frame `map`
  double radius_m = 0;           ///< features with some point this near are found
};

/// What one drive says of a map, as the store has it. The store keeps the document and does not read it.
struct StoredEvidence {
  std::string added_at;  ///< UTC, by the store's clock: "2026-11-21T14:02:11Z"
  std::string added_by;  ///< the role that added it
  std::string document;  ///< JSON, UTF-8: equal to what was added but for its layout
};

/// One answer to a NearQuery.
struct NearFeature {
  MapFeatureNumber number = {};  ///< in the stored map
  std::string id;                ///< MapFeature::id
  std::string object;            ///< id of the object that it belongs to
  std::string object_type;       ///< MapObject::type: "opal:Wall"
  Geometry geometry;             ///< as mapped, frame `map`
  double distance_m = 0;         ///< shortest, to the geometry; a circle is its rim (opal::distance_m)
};

/// Keeps the maps of many buildings, in versions, for many robots (thesis C.2). Slow beside a MapView: a robot preloads
/// the whole map from it and asks the MapView while it drives. Calls may come from several threads and processes at
/// once. Making one connects to nothing; the credentials come from where the store's own tools find them.
///
/// Every call throws StoreUnreachable if the store cannot be reached, and StoreError naming what was asked for, what
/// was found and what was expected.
class OPAL_EXPORT MapStore {
 public:
  virtual ~MapStore();
  /// Which store this is, for people, without secrets and without connecting: "database maps on db.example:5432".
  virtual std::string where() const = 0;
  /// Adds a version, whole or not at all. Of pushes at the same time each becomes a version of its own.
  /// @throws StoreConflict if `expected_version` is not the newest.
  virtual StoredVersion push(const SemanticMap& map, const MapPush& request) const = 0;
  /// Fetches one version with its map.
  /// @param building  name of the building.
  /// @param version   0: the newest.
  /// @throws StoreError if there is no such building or version.
  virtual StoredMap pull(const std::string& building, int version) const = 0;
  /// In order of building and version. @param building  empty: all buildings. An unknown one has no versions.
  virtual std::vector<StoredVersion> list(const std::string& building) const = 0;
  /// In order of number; the same features as MapView::within finds. @throws StoreError as `pull` does.
  virtual std::vector<NearFeature> features_near(const NearQuery& query) const = 0;
  /// Adds what drives say of one version of a map: all of it or nothing. A document that is there already counts once,
  /// so that whoever does not know whether it has arrived adds it again.
  /// @param building  name of the building.
  /// @param version   that the drives were compared with, from 1 on.
  /// @param documents  JSON, a drive each.
  /// @return how many of them are new. @throws StoreError as `pull` does, and for what is no JSON.
  virtual int add_evidence(const std::string& building, int version,
                           const std::vector<std::string>& documents) const = 0;
  /// All that drives say of one version, in an order that does not depend on when it arrived.
  /// @param building  name of the building.
  /// @param version   0: the newest. @throws StoreError as `pull` does.
  virtual std::vector<StoredEvidence> evidence(const std::string& building, int version) const = 0;
};

}  // namespace opal
