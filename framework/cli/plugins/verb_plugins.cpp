#include "cli/options/exit_code.hpp"
#include "cli/options/verbs.hpp"
#include "cli/plugins/trusted_list.hpp"
#include "common/phrases.hpp"
#include "deployment/localizer_options.hpp"
#include "plugin/class_source.hpp"

#include <opal/plugin/plugin_folders.hpp>
#include <opal/plugin/plugin_registry.hpp>
#include <opal/plugin/testing/plugin_contract.hpp>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <iostream>
#include <memory>
#include <set>

namespace opal::cli {
namespace {

using nlohmann::ordered_json;

struct PluginsRequest {
  std::vector<std::string> places;  ///< folders and files
  bool as_json = false;
  bool check = false;
  TrustedListRequest trusted;
};

/// What was found, and what was wrong with it: one sentence each.
struct Inventory {
  std::vector<RegisteredType> types;
  std::vector<std::string> refused;
  std::vector<std::string> violations;
  std::vector<std::string> kept;  ///< files and classes that keep their contract
};

/// Those of the program, and those of the environment. @return the refusals
std::vector<std::string> load_all(PluginRegistry& registry) {
  std::vector<std::string> refused;
  for (const std::string& folder : plugin_folders())
    for (std::string& refusal : registry.load_all(folder)) refused.push_back(std::move(refusal));
  return refused;
}

/// @return the refusals
std::vector<std::string> load(PluginRegistry& registry, const std::string& place) {
  namespace fs = std::filesystem;
  if (!fs::exists(place)) return {place + ": does not exist, expected a plugin, or a folder of plugins"};
  if (fs::path(place).extension() == ".py") return {place + ": names no class, expected FILE.py:CLASS"};
  if (!fs::is_regular_file(place)) return registry.load_all(place);
  try {
    registry.load(place);
    return {};
  } catch (const PluginError& refusal) {
    return {refusal.what()};
  }
}

/// @param violations  of its contract.
void judge(const std::string& what, const std::vector<std::string>& violations, Inventory& inventory) {
  inventory.violations.insert(inventory.violations.end(), violations.begin(), violations.end());
  if (violations.empty()) inventory.kept.push_back(what + ": keeps the contract of its kind");
}

void look_into(const std::string& place, PluginRegistry& registry, Inventory& inventory) {
  if (read_class_source(place)) return judge(place, testing::class_violations(place), inventory);
  const std::size_t before = registry.types().size();
  std::vector<std::string> refused = load(registry, place);
  if (refused.empty() && registry.types().size() == before)
    refused.push_back(place + ": holds no plugin, expected NAME.so with NAME.jsonld beside it");
  inventory.refused.insert(inventory.refused.end(), refused.begin(), refused.end());
}

Inventory look_into(const PluginsRequest& request) {
  Inventory inventory;
  PluginRegistry registry;
  for (const std::string& place : request.places) look_into(place, registry, inventory);
  if (request.places.empty()) inventory.refused = load_all(registry);
  inventory.types = registry.types();
  if (!request.check) return inventory;
  std::set<std::string> files;
  for (const RegisteredType& type : inventory.types) files.insert(type.file);
  for (const std::string& file : files) judge(file, testing::plugin_violations(file), inventory);
  return inventory;
}

ordered_json to_json(const OptionInfo& option) {
  return {{"name", option.name},
          {"type", option.type},
          {"unit", option.unit},
          {"default", option.default_value},
          {"minimum", option.minimum},
          {"maximum", option.maximum},
          {"description", option.description}};
}

ordered_json to_json(const RegisteredType& type) {
  ordered_json options = ordered_json::array();
  for (const OptionInfo& option : type.options) options.push_back(to_json(option));
  return {{"type", type.info.name},          {"kind", name_of(type.kind)},
          {"description", type.description}, {"plugin", type.plugin},
          {"version", type.version},         {"file", type.file},
          {"consumes", type.info.consumes},  {"produces", type.info.produces},
          {"on_request", type.on_request},   {"options", options}};
}

void print_json(std::ostream& out, const Inventory& inventory) {
  ordered_json types = ordered_json::array();
  for (const RegisteredType& type : inventory.types) types.push_back(to_json(type));
  ordered_json stages = ordered_json::array();
  for (const DescribedStage& stage : describe_stages()) {
    stages.push_back({{"name", stage.name}, {"description", stage.description}, {"options", ordered_json::array()}});
    for (const OptionInfo& option : stage.options) stages.back()["options"].push_back(to_json(option));
  }
  out << ordered_json{{"types", types},
                      {"stages", stages},
                      {"refused", inventory.refused},
                      {"violations", inventory.violations}}
             .dump(2)
      << "\n";
}

void print(std::ostream& out, const OptionInfo& option) {
  out << "    " << option.name << " = " << option.default_value.dump();
  if (!option.unit.empty()) out << " " << option.unit;
  out << "  (" << accepted_values(option) << ")  " << option.description << "\n";
}

void print(std::ostream& out, const RegisteredType& type) {
  out << "  " << type.info.name << "  from " << type.plugin << " " << type.version << "\n    " << type.description
      << "\n";
  if (!type.info.consumes.empty()) out << "    consumes " << listed(type.info.consumes) << "\n";
  if (!type.info.produces.empty()) out << "    produces " << listed(type.info.produces) << "\n";
  if (type.on_request) out << "    on request: runs where a map's patterns or a deployment name it\n";
  for (const OptionInfo& option : type.options) print(out, option);
}

void print_kind(std::ostream& out, const std::vector<RegisteredType>& types, PluginKind kind) {
  bool first = true;
  for (const RegisteredType& type : types) {
    if (type.kind != kind) continue;
    if (first) out << name_of(kind) << "\n";
    first = false;
    print(out, type);
  }
  if (!first) out << "\n";
}

/// What a deployment's "stages" accepts.
void print_stages(std::ostream& out) {
  out << "Stages of the localizer\n";
  for (const DescribedStage& stage : describe_stages()) {
    out << "  " << stage.name << "\n    " << stage.description << "\n";
    for (const OptionInfo& option : stage.options) print(out, option);
  }
  out << "\n";
}

void print_sentences(std::ostream& out, const std::string& title, const std::vector<std::string>& sentences) {
  if (sentences.empty()) return;
  out << title << "\n";
  for (const std::string& sentence : sentences) out << "  " << sentence << "\n";
}

void print_types(std::ostream& out, const std::vector<RegisteredType>& types) {
  for (const PluginKind kind :
       {PluginKind::log_source, PluginKind::map_importer, PluginKind::scan_matcher, PluginKind::feature_detector,
        PluginKind::pattern_template, PluginKind::hypothesis_scorer, PluginKind::map_store})
    print_kind(out, types, kind);
}

void print_text(std::ostream& out, const Inventory& inventory, const PluginsRequest& request) {
  if (!request.check) print_types(out, inventory.types);
  if (!request.check && request.places.empty()) print_stages(out);
  for (const std::string& sentence : inventory.kept) out << sentence << "\n";
  print_sentences(out, "Refused", inventory.refused);
  print_sentences(out, "Broken contracts", inventory.violations);
}

}  // namespace

void add_plugins_verb(CLI::App& app, int& exit_code) {
  const auto request = std::make_shared<PluginsRequest>();
  CLI::App* verb =
      app.add_subcommand("plugins", "list what plugins offer: types, options, and files that were refused");
  verb->add_option("place", request->places,
                   "folders of plugins, single files, or a class, FILE.py:CLASS, for its contract; default: the "
                   "program's own and those in OPAL_PLUGIN_PATH");
  verb->add_flag("--json", request->as_json, "print JSON");
  verb->add_flag("--check", request->check, "put each plugin through the contract of its kind instead of listing it");
  CLI::Option* digests = verb->add_option(
      "--digests", request->trusted.config,
      "print trusted_plugins of a deployment: the SHA-256 of each plugin and class file that it runs, ready to paste");
  verb->add_option("--map", request->trusted.map, "the map, instead of the deployment's")->needs(digests);
  verb->add_option("--log", request->trusted.log, "a recorded log that is to be read")->needs(digests);
  verb->callback([request, &exit_code] {
    if (!request->trusted.config.empty()) {
      std::cout << trusted_list(request->trusted);
      return;
    }
    const Inventory inventory = look_into(*request);
    request->as_json ? print_json(std::cout, inventory) : print_text(std::cout, inventory, *request);
    exit_code = inventory.refused.empty() && inventory.violations.empty() ? kDone : kNo;
  });
}

}  // namespace opal::cli
