#pragma once

#include "viewer/serving/live_feed.hpp"
#include "viewer/serving/live_server.hpp"

#include <stop_token>
#include <string>

/// A run that people watch in a browser while it goes on, until Ctrl-C.
class LiveView {
 public:
  /// Serves at once. @param stop  Ctrl-C; whoever waits for it was made first, so that threads leave signals to it.
  /// @throws opal::Error if the port cannot be had.
  /// @param window  of the run that is kept for those who watch.
  LiveView(int port, std::stop_token stop, opal::RecordWindow window = {});

  opal::EventSink& events() { return feed_; }
  std::string url() const { return server_.url(); }

  /// No more events come: the page is told, and stays until Ctrl-C.
  void end();

 private:
  std::stop_token stop_;
  opal::RecordLog records_;
  opal::LiveFeed feed_{records_};
  opal::LiveServer server_;
};

/// Every event to two listeners.
class EventSplitter final : public opal::EventSink {
 public:
  EventSplitter(opal::EventSink& one, opal::EventSink& other) : one_(one), other_(other) {}
  bool listening() const override { return one_.listening() || other_.listening(); }
  void write(const nlohmann::ordered_json& event) override {
    one_.write(event);
    other_.write(event);
  }

 private:
  opal::EventSink &one_, &other_;
};
