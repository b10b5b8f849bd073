#pragma once

#include "viewer/serving/live_feed.hpp"
#include "viewer/serving/live_server.hpp"

#include <stop_token>
#include <string>

namespace opal::cli {

/// A run that people watch in a browser while it goes on, until Ctrl-C.
class LiveView {
 public:
  /// Serves at once. @param stop  Ctrl-C; whoever waits for it was made first, so that threads leave signals to it.
  /// @throws opal::Error if the port cannot be had.
  /// @param window  of the run that is kept for those who watch.
  LiveView(int port, std::stop_token stop, RecordWindow window = {});

  EventSink& events() { return feed_; }
  std::string url() const { return server_.url(); }

  /// No more events come: the page is told, and stays until Ctrl-C.
  void end();

 private:
  std::stop_token stop_;
  RecordLog records_;
  LiveFeed feed_{records_};
  LiveServer server_;
};

/// Every event to two listeners.
class EventSplitter final : public EventSink {
 public:
  EventSplitter(EventSink& one, EventSink& other) : one_(one), other_(other) {}
  bool listening() const override { return one_.listening() || other_.listening(); }
  void write(const nlohmann::ordered_json& event) override {
    one_.write(event);
    other_.write(event);
  }

 private:
  EventSink &one_, &other_;
};

}  // namespace opal::cli
