// libFuzzer entry point: any text gives a deployment or an opal::Error.
#include <opal/common/error.hpp>
#include <opal/deployment/deployment.hpp>

#include <cstdint>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    opal::parse_deployment(std::string(reinterpret_cast<const char*>(data), size), "fuzz");
  } catch (const opal::Error&) {
  }
  return 0;
}
