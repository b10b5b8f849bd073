#include "session/program_log.hpp"

#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <memory>

namespace opal::session {

void log_to_stderr() {
  const auto log = std::make_shared<spdlog::logger>("opal", std::make_shared<spdlog::sinks::stderr_sink_mt>());
  log->set_pattern("%v");
  spdlog::set_default_logger(log);
}

}  // namespace opal::session
