// synthetic_run FILE [UPDATES HYPOTHESES POINTS TIME_LINES WINDOW_S]: writes a synthetic event stream, to measure `opal
// view` with. With WINDOW_S it writes what the page of a run gets that keeps so many seconds.
#include "tests/viewer/synthetic_run.hpp"
#include "viewer/serving/live_feed.hpp"

#include <cstdlib>
#include <fstream>
#include <iostream>

namespace {

/// Writes the records of each update before the next one begins.
class RecordWriter final : public opal::EventSink {
 public:
  RecordWriter(std::ostream& out, double window_s) : out_(out), log_({.seconds = window_s}) {}
  bool listening() const override { return true; }
  void write(const nlohmann::ordered_json& event) override {
    feed_.write(event);
    if (event["event"] != "cost") return;
    do out_ << *log_.wait(position_++, {}, std::chrono::minutes(1)).record << '\n';
    while (position_ < 3);
  }

 private:
  std::ostream& out_;
  opal::RecordLog log_;
  opal::LiveFeed feed_{log_};
  std::size_t position_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::cerr << "usage: synthetic_run FILE [UPDATES HYPOTHESES POINTS TIME_LINES WINDOW_S]\n";
    return 2;
  }
  const auto number = [&](int place, int otherwise) { return argc > place ? std::atoi(argv[place]) : otherwise; };
  const opal::synthetic::RunSize size{number(2, 10000), number(3, 200), number(4, 360), number(5, 1)};
  std::ofstream file(argv[1]);
  if (argc > 6) {
    RecordWriter records(file, number(6, 600));
    opal::synthetic::write_run(size, records);
  } else {
    opal::JsonLinesSink sink(file);
    opal::synthetic::write_run(size, sink);
  }
  return file ? 0 : 3;
}
