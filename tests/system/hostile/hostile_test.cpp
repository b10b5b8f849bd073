#include "child_trials.hpp"
#include "mutator.hpp"
#include "seeds.hpp"
#include "whole_import.hpp"

#include <opal/plugin/plugin_registry.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>

namespace {

using Read = std::function<std::string(const std::string&, const std::string&)>;

struct Format {
  std::string name;
  std::string file_name;
  char reference;
  unsigned mutants;
};

/// OPAL_HOSTILE_TIMES=10 tries ten times as many.
unsigned times() {
  const char* text = std::getenv("OPAL_HOSTILE_TIMES");
  return text == nullptr ? 1 : static_cast<unsigned>(std::max(1, std::atoi(text)));
}

/// Number k damages seed k modulo their number, so that a failure can be made again.
std::vector<std::string> mutants(const Format& format, const std::vector<std::string>& seeds) {
  std::vector<std::string> texts{"", "\n", std::string(1, '\0')};
  for (unsigned k = 0; k < times() * format.mutants; ++k)
    texts.push_back(Mutator(k).damaged(seeds[k % seeds.size()], format.reference));
  return texts;
}

void keep(const Format& format, std::size_t number, const std::string& text) {
  std::ofstream("hostile-" + std::to_string(number) + "-" + format.file_name, std::ios::binary) << text;
}

void survive(const Format& format, const std::vector<std::string>& seeds, const Read& read) {
  for (const Trial& trial : read_in_children(format.file_name, seeds, read)) {
    INFO("undamaged: " << trial.message);
    REQUIRE(trial.result == Trial::Result::accepted);
  }
  const std::vector<std::string> texts = mutants(format, seeds);
  const std::vector<Trial> trials = read_in_children(format.file_name, texts, read);
  int accepted = 0, refused = 0;
  for (std::size_t k = 0; k < trials.size(); ++k) {
    accepted += trials[k].result == Trial::Result::accepted;
    refused += trials[k].result == Trial::Result::refused;
    if (trials[k].result != Trial::Result::failed) continue;
    keep(format, k, texts[k]);
    FAIL_CHECK(format.name << ", damaged file " << k << " (kept beside the test as hostile-" << k << "-"
                           << format.file_name << "): " << trials[k].message);
  }
  std::cout << format.name << ": " << trials.size() << " damaged files, " << refused << " refused, " << accepted
            << " accepted whole\n";
  CHECK(refused > 0);
  CHECK(accepted > 0);
}

std::shared_ptr<const opal::MapImporter> importer(const std::string& plugin, const std::string& type,
                                                  const nlohmann::json& options) {
  opal::PluginRegistry registry;
  registry.load(OPAL_PLUGIN_DIR "/" + plugin + ".so");
  return registry.make<opal::MapImporter>(type, options);
}

}  // namespace

TEST_CASE("damaged drawings are refused by name or come in whole") {
  const auto dxf = importer("dxf_importer", "opal:DxfImporter", nlohmann::json::object());
  survive({"DXF", "plan.dxf", '\n', 900}, dxf_seeds(),
          [&](const std::string& path, const std::string& text) { return whole_dxf(dxf->import(path), text); });
}

TEST_CASE("damaged GeoJSON is refused by name or comes in whole") {
  const auto geojson = importer("geojson_importer", "opal:GeoJsonImporter", nlohmann::json::object());
  survive({"GeoJSON", "plan.geojson", '"', 600}, geojson_seeds(),
          [&](const std::string& path, const std::string& text) { return whole_geojson(geojson->import(path), text); });
}

TEST_CASE("damaged map documents are refused by name or come in whole") {
  survive({"JSON-LD", "map.jsonld", '"', 600}, map_seeds(), [](const std::string& path, const std::string& text) {
    return whole_map(*opal::SemanticMap::read(path), text);
  });
}

TEST_CASE("damaged building models are refused by name or come in whole") {
  if (!std::filesystem::exists(OPAL_PLUGIN_DIR "/ifc_importer.so")) {
    WARN("skipped: there is no ifc_importer");
    return;
  }
  const auto ifc = importer("ifc_importer", "opal:IfcImporter", nlohmann::json::object());
  survive({"IFC", "building.ifc", '#', 600}, ifc_seeds(),
          [&](const std::string& path, const std::string& text) { return whole_ifc(ifc->import(path), text); });
}
