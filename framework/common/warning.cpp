#include <opal/common/warning.hpp>

#include <fmt/format.h>
#include <spdlog/logger.h>
#include <spdlog/sinks/base_sink.h>

#include <cstdio>
#include <memory>
#include <mutex>

namespace opal {
namespace {

/// One at a time, to where they go.
class Warnings final : public spdlog::sinks::base_sink<std::mutex> {
 public:
  void go_to(WarningSink where) {
    const std::lock_guard lock(mutex_);
    where_ = std::move(where);
  }

 protected:
  void sink_it_(const spdlog::details::log_msg& message) override {
    const std::string_view line(message.payload.data(), message.payload.size());
    where_ ? where_(line) : fmt::print(stderr, "{}\n", line);
  }
  void flush_() override {}

 private:
  WarningSink where_;
};

/// In no registry of spdlog: loggers of the process are those of the program that embeds Opal.
struct Log {
  std::shared_ptr<Warnings> warnings = std::make_shared<Warnings>();
  spdlog::logger logger{"opal", warnings};
};

Log& log() {
  static Log one;
  return one;
}

}  // namespace

void set_warning_sink(WarningSink sink) { log().warnings->go_to(std::move(sink)); }

void warn(std::string_view line) { log().logger.warn(line); }

}  // namespace opal
