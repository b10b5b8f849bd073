// CARMEN logs, plain or compressed, through the plugin and on into a replay.
#include <opal/plugin/plugin_registry.hpp>
#include <opal/sensing/replay.hpp>

#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace {

/// A file in memory, with a name.
class MemoryFile {
 public:
  MemoryFile(const std::uint8_t* data, std::size_t size) : descriptor_(memfd_create("log", 0)) {
    if (descriptor_ < 0 || ::write(descriptor_, data, size) != static_cast<ssize_t>(size)) std::abort();
  }
  ~MemoryFile() { close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
  int descriptor_;
};

std::shared_ptr<const opal::LogSource> carmen_log() {
  static opal::PluginRegistry registry;
  if (!registry.has("opal:CarmenLog")) registry.load(OPAL_PLUGIN_DIR "/carmen_log.so");
  return registry.make<opal::LogSource>("opal:CarmenLog");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::shared_ptr<const opal::LogSource> source = carmen_log();
  const MemoryFile file(data, size);
  if (!source->recognizes(file.path())) return 0;
  opal::Replay replay(source->open(file.path()), {opal::LaserModel{}});
  while (const auto sample = replay.next())
    if (!sample->T_odom_base.position().allFinite()) std::abort();
  return 0;
}
