#pragma once

#include <opal/localization/localizer.hpp>

#include <functional>
#include <memory>
#include <string>

namespace opal::remote {

/// Localizes one robot whose behaviours are another program on this machine (Hendrikx 2023, 4.4.2), over HTTP
/// on 127.0.0.1: `GET /v1/map`, `POST /v1/begin`, `POST /v1/scans` (docs/drive.md). A message that cannot be
/// used is answered by a sentence that says why, and changes nothing. Whoever begins a drive last is the
/// robot; the one before is told so.
class LocalizationServer {
 public:
  static constexpr int kUsualPort = 8714;
  /// Makes the localizer of a robot that has this laser.
  using Maker = std::function<std::unique_ptr<Localizer>(const LaserModel&)>;

  /// Serves at once, from threads of its own.
  /// @param sensor  whose features of the map are used.
  /// @param port  0: any free one. @throws Error if it cannot be listened on.
  LocalizationServer(const std::shared_ptr<const SemanticMap>& map, std::string sensor, Maker make,
                     int port = kUsualPort);
  ~LocalizationServer();
  LocalizationServer(const LocalizationServer&) = delete;
  LocalizationServer& operator=(const LocalizationServer&) = delete;

  int port() const;
  std::string address() const;  ///< "127.0.0.1:8714"

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace opal::remote
