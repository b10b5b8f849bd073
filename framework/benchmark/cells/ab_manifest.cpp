#include "benchmark/cells/ab_manifest.hpp"

#include "benchmark/ab/records/program_files.hpp"
#include "common/digest/sha256.hpp"

namespace opal::benchmark {

namespace ab = opal::ab;
using nlohmann::ordered_json;

ordered_json manifest_of(const ab::Experiment& experiment, const std::vector<ArmPlugins>& plugins,
                         WorldSource& worlds) {
  constexpr int kFormat = 1;
  ordered_json manifest{{"format", kFormat}, {"opal", ab::program_files()}, {"experiment", experiment.document}};
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
    digests.push_back(opal::sha256_of(manifest.at("opal").dump() + arm.dump()).substr(0, kDigits));
  return digests;
}

}  // namespace opal::benchmark
