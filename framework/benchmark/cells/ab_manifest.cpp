#include "benchmark/cells/ab_manifest.hpp"

#include "benchmark/ab/records/sha256.hpp"

#include <opal/common/error.hpp>
#include <opal/plugin/plugin_folders.hpp>

#include <dlfcn.h>

namespace {

namespace ab = opal::ab;
using nlohmann::ordered_json;

std::string library_file() {
  Dl_info info{};
  if (dladdr(reinterpret_cast<const void*>(&opal::own_plugin_folder), &info) == 0)
    throw opal::Error("libopal.so: the file that this program uses cannot be found");
  return info.dli_fname;
}

ordered_json program_json() {
  return {{"version", OPAL_VERSION},
          {"program_sha256", ab::sha256_of_file("/proc/self/exe")},
          {"library_sha256", ab::sha256_of_file(library_file())}};
}

}  // namespace

ordered_json manifest_of(const ab::Experiment& experiment, const std::vector<ArmPlugins>& plugins,
                         WorldSource& worlds) {
  constexpr int kFormat = 1;
  ordered_json manifest{{"format", kFormat}, {"opal", program_json()}, {"experiment", experiment.document}};
  manifest["arms"] = ordered_json::array();
  for (std::size_t k = 0; k < experiment.arms.size(); ++k)
    manifest["arms"].push_back({{"name", experiment.arms[k].name},
                                {"configuration", experiment.arms[k].configuration},
                                {"plugins", plugins[k].files}});
  manifest["inputs"] = ordered_json::object();
  for (const ab::Scenario& scenario : experiment.scenarios) manifest["inputs"][scenario.name] = worlds.inputs(scenario);
  return manifest;
}

std::vector<std::string> arm_digests(const ordered_json& manifest) {
  constexpr std::size_t kDigits = 16;
  std::vector<std::string> digests;
  for (const ordered_json& arm : manifest.at("arms"))
    digests.push_back(ab::sha256_of(manifest.at("opal").dump() + arm.dump()).substr(0, kDigits));
  return digests;
}
