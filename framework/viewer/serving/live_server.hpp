#pragma once

#include "viewer/serving/record_log.hpp"

#include <memory>
#include <string>

namespace opal {

/// Serves a run while it goes on: `GET /` is the page, `GET /events` the records from the first one on as server-sent
/// events (page/README.md). For people on this machine only: it listens on 127.0.0.1, and refuses requests that name
/// another host, as those of a web page elsewhere would that has its own name point here (DNS rebinding).
///
/// Every connection reads the log at its own pace. One that takes nothing for seconds is closed; a browser then comes
/// back by itself and goes on where it was (`Last-Event-ID`). If the log has dropped what comes next, the connection is
/// given the run from its first records on.
class LiveServer {
 public:
  static constexpr int kUsualPort = 8713;
  static constexpr int kMostStreams = 16;  ///< one more is told to try again later

  /// Serves at once, from threads of its own.
  /// @param page  the HTML text of `GET /`.
  /// @param records  must outlive the server.
  /// @param port  0: any free one. @throws Error if it cannot be listened on.
  LiveServer(std::string page, const RecordLog& records, int port = kUsualPort);
  /// Closes all connections. Takes seconds if one of them is stalled in the middle of a record.
  ~LiveServer();
  LiveServer(const LiveServer&) = delete;
  LiveServer& operator=(const LiveServer&) = delete;

  int port() const;
  std::string url() const;  ///< "http://127.0.0.1:8713/"
  int streams() const;      ///< connections to `/events` now

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace opal
