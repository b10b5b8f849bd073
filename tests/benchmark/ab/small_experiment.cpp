#include "small_experiment.hpp"

namespace opal::ab_tests {

using nlohmann::json;

namespace {

json arm(const std::string& name, const std::string& scorer) {
  return {{"name", name}, {"overrides", {{"scorers", {{{"@type", scorer}}}}}}};
}

}  // namespace

json small_experiment() {
  return {{"@context", "urn:opal:v1"},
          {"@type", "opal:Experiment"},
          {"name", "two scorers"},
          {"arms", {arm("evidence", "opal:Evidence"), arm("lack_of_fit", "opal:LackOfFit")}},
          {"sites", {{{"prefix", std::string(OPAL_SOURCE_DIR) + "/maps/malaga/malaga-demo"}}}},
          {"limits", {{"cell_s", 100}}}};
}

json experiment_with_drives() {
  json experiment = small_experiment();
  const json building{{"kind", "corridor"}, {"size_m2", 300}};
  experiment["simulated"] = {
      {{"name", "corridor"}, {"building", building}, {"drives", 2}, {"distance_m", 8}, {"people", 1}, {"seeds", 3}}};
  return experiment;
}

json faulty_arm(const std::string& how, int after) {
  json faulty = arm(how, "faulty:Scorer");
  faulty["overrides"]["scorers"][0]["options"] = {{"how", how}, {"after", after}};
  faulty["plugins"] = OPAL_FAULTY_PLUGIN_DIR;
  return faulty;
}

std::string written(const TemporaryFolder& folder, const json& experiment, const std::string& name) {
  return folder.write(name, experiment.dump(1));
}

}  // namespace opal::ab_tests
