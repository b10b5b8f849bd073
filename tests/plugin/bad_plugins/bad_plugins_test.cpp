#include "plugin_files.hpp"

#include "tests/kit/refusal.hpp"

#include <opal/plugin/plugin.hpp>
#include <opal/plugin/plugin_registry.hpp>

#include <catch2/catch.hpp>

#include <dlfcn.h>

#include <cstdlib>

using opal::FeatureDetector;
using opal::PluginRegistry;
using opal_test::bad_plugin;
using opal_test::PluginFolder;

namespace {

/// Loads into a registry that holds the good plugin, and checks that a refusal changes nothing there.
std::string refusal_of(const std::string& path) {
  PluginRegistry registry;
  registry.load(bad_plugin("good.so"));
  const std::string message = opal::refused_with<opal::PluginError>([&] { registry.load(path); });
  if (message != "accepted") {
    CHECK(registry.types().size() == 1);
    CHECK(registry.make<FeatureDetector>("bad:good")->detect({}).size() == 4);
  }
  return message;
}

template <class T>
std::string failure_to_make(const std::string& plugin, const nlohmann::json& options = nlohmann::json::object()) {
  PluginRegistry registry;
  registry.load(bad_plugin(plugin + ".so"));
  return opal::refused_with<opal::PluginError>([&] { registry.make<T>("bad:" + plugin, options); });
}

/// The plugin "other_description" in a folder of its own, with its description changed.
std::string refusal_with_description(const std::string& pointer, const nlohmann::json& value) {
  const PluginFolder folder;
  const std::string file = folder.copy(bad_plugin("other_description.so"));
  auto description = nlohmann::json::parse(opal::content_of(bad_plugin("other_description.jsonld")));
  description[nlohmann::json::json_pointer(pointer)] = value;
  folder.write("other_description.jsonld", description.dump());
  std::string message = refusal_of(file);
  for (auto at = message.find(folder.path()); at != std::string::npos; at = message.find(folder.path()))
    message.replace(at, folder.path().size(), "FOLDER");
  return message;
}

}  // namespace

TEST_CASE("a good plugin is loaded, also after strip") {
  const std::string file = bad_plugin(GENERATE("good.so", "good_stripped.so"));
  CAPTURE(file);
  PluginRegistry registry;
  registry.load(file);
  REQUIRE(registry.types().size() == 1);
  const opal::RegisteredType type = registry.type("bad:good");
  CHECK(type.plugin == "good");
  CHECK(type.version == "1.2.3");
  CHECK(type.file == file);
  CHECK(type.kind == opal::PluginKind::feature_detector);
  CHECK(type.info.produces == std::vector<std::string>{"bad:Thing"});
  CHECK(registry.make<FeatureDetector>("bad:good")->detect({}).size() == 4);
  CHECK(registry.make<FeatureDetector>("bad:good", {{"count", 7}})->detect({}).size() == 7);
}

TEST_CASE("a detector outlives the registry that made it") {
  std::shared_ptr<const FeatureDetector> detector;
  {
    PluginRegistry registry;
    registry.load(bad_plugin("good.so"));
    detector = registry.make<FeatureDetector>("bad:good");
  }
  CHECK(detector->detect({}).size() == 4);
}

TEST_CASE("a plugin is found through a symbolic link, with the description beside the file itself") {
  const PluginFolder folder;
  const std::string link = folder.path() + "/link.so";
  std::filesystem::create_symlink(bad_plugin("good.so"), link);
  PluginRegistry registry;
  registry.load(link);
  CHECK(registry.type("bad:good").file == bad_plugin("good.so"));
}

TEST_CASE("a type is made as what it is") {
  PluginRegistry registry;
  registry.load(bad_plugin("good.so"));
  CHECK_THROWS_WITH(registry.make<opal::HypothesisScorer>("bad:good"),
                    "bad:good from good 1.2.3 is a FeatureDetector, expected a HypothesisScorer");
  CHECK_THROWS_WITH(registry.make<FeatureDetector>("bad:goods"), "no plugin offers bad:goods; there is: bad:good");
  CHECK_THROWS_WITH(registry.make<FeatureDetector>("bad:good", {{"count", 101}}),
                    "bad:good: option count: 101, expected an integer from 0 to 100");
}

TEST_CASE("a factory that throws is named with its plugin and the cause") {
  const std::string origin = "bad:throws_in_factory from throws_in_factory 1.2.3: cannot be made: ";
  CHECK(failure_to_make<FeatureDetector>("throws_in_factory", {{"count", 1}}) ==
        origin + "count 1 does not go with anything");
  CHECK(failure_to_make<FeatureDetector>("throws_in_factory", {{"count", 2}}) ==
        origin + "an exception of the plugin's own");
  CHECK(failure_to_make<FeatureDetector>("throws_in_factory", {{"count", 3}}) ==
        origin + "threw something that is no std::exception");
  CHECK(failure_to_make<FeatureDetector>("throws_in_factory") == "accepted");
}

TEST_CASE("a factory that returns null is named with its plugin") {
  CHECK(failure_to_make<FeatureDetector>("returns_null") ==
        "bad:returns_null from returns_null 1.2.3: cannot be made: its factory returned null");
}

TEST_CASE("plugins that fail only when they are called are loaded and made") {
  CHECK(failure_to_make<FeatureDetector>("throws_in_detect") == "accepted");
  CHECK(failure_to_make<opal::HypothesisScorer>("throws_in_score") == "accepted");
  CHECK(failure_to_make<opal::PatternTemplate>("throws_in_match") == "accepted");
}

TEST_CASE("a plugin that throws while it registers is refused whole") {
  const std::string file = bad_plugin("throws_in_registration.so");
  CHECK(refusal_of(file) == file + ": failed to register its types: no licence found");
}

TEST_CASE("a plugin that registers a name twice is refused") {
  const std::string file = bad_plugin("registers_twice.so");
  CHECK(refusal_of(file) == file + ": registers bad:registers_twice twice");
}

TEST_CASE("a plugin that offers a name which another one offers is refused whole, both files are named") {
  const std::string file = bad_plugin("taken_name.so");
  CHECK(refusal_of(file) ==
        file + ": offers bad:good, which " + bad_plugin("good.so") + " (good 1.2.3) offers already");
}

TEST_CASE("a plugin that is loaded already is refused") {
  const std::string file = bad_plugin("good.so");
  CHECK(refusal_of(file) == file + ": is loaded already");
}

TEST_CASE("a plugin with another ABI is refused, both tags are printed") {
  const std::string ours = std::string("\", this is \"") + opal::kAbiTag +
                           " eigen_align=" + std::to_string(EIGEN_MAX_ALIGN_BYTES) +
                           "\"; build it anew against the headers of this Opal, with its compiler and flags";
  const std::string tag = bad_plugin("wrong_tag.so");
  CHECK(refusal_of(tag) ==
        tag + ": was built for \"api=1 gxx_abi=1002 eigen_align=" + std::to_string(EIGEN_MAX_ALIGN_BYTES) + ours);
  const std::string alignment = bad_plugin("wrong_alignment.so");
  CHECK(refusal_of(alignment) == alignment + ": was built for \"" + opal::kAbiTag +
                                     " eigen_align=" + std::to_string(2 * EIGEN_MAX_ALIGN_BYTES) + ours);
}

TEST_CASE("a plugin for another API is refused, both are named") {
  const std::string file = bad_plugin("wrong_api.so");
  CHECK(refusal_of(file) == file + ": was built for plugin API 2, this is 1");
}

TEST_CASE("a plugin with an undefined symbol is refused at load, the symbol is named") {
  const std::string file = bad_plugin("undefined_symbol.so");
  CHECK(refusal_of(file) == file + ": cannot be opened: undefined symbol: opal_test_function_that_nobody_defines");
}

TEST_CASE("a library with the section of a plugin, but without its symbol, is refused") {
  const std::string file = bad_plugin("no_symbol.so");
  CHECK(refusal_of(file) == file + ": has a section opal_v1, but no symbol opal_plugin_v1");
}

TEST_CASE("a plugin with an incomplete descriptor is refused") {
  const std::string file = bad_plugin("incomplete.so");
  CHECK(refusal_of(file) == file + ": its descriptor lacks a name, a version or a function that registers types");
}

TEST_CASE("a plugin that registers a type without a factory is refused") {
  const std::string file = bad_plugin("no_factory.so");
  CHECK(refusal_of(file) == file + ": bad:no_factory is registered without a factory");
}

TEST_CASE("an ordinary library is no plugin, and is never opened") {
  const std::string file = bad_plugin("ordinary_library.so");
  CHECK(refusal_of(file) == file + ": is no Opal plugin: it has no section opal_v1");
  CHECK(std::getenv("OPAL_TEST_ORDINARY_LIBRARY_WAS_OPENED") == nullptr);
}

TEST_CASE("a text file named like a library is refused") {
  const PluginFolder folder;
  const std::string file =
      folder.write("text.so", "just some words, longer than an ELF header is: " + std::string(99, '.'));
  CHECK(refusal_of(file) == file + ": is no shared library: it does not begin with the ELF magic number");
}

TEST_CASE("a missing file and a folder are refused") {
  const PluginFolder folder;
  CHECK(refusal_of(folder.path() + "/absent.so") == folder.path() + "/absent.so: there is no such file");
  CHECK(refusal_of(folder.path()) == folder.path() + ": is no file");
}

TEST_CASE("a plugin without its description is refused") {
  const PluginFolder folder;
  const std::string file = folder.copy(bad_plugin("other_description.so"));
  CHECK(refusal_of(file) == folder.path() +
                                "/other_description.jsonld: cannot be read; every plugin has its description beside "
                                "it (docs/write_a_plugin.md)");
}

TEST_CASE("a plugin with an invalid description is refused") {
  CHECK(refusal_with_description("/types/0/options/0/default", 1000) ==
        "FOLDER/other_description.jsonld: /types/0/options/0/default: 1000, expected an integer from 0 to 100");
}

TEST_CASE("a plugin that its description does not fit is refused") {
  const std::string file = "FOLDER/other_description.so: ";
  CHECK(refusal_with_description("/version", "1.2.4") ==
        file +
            "calls itself other_description 1.2.3, but FOLDER/other_description.jsonld describes "
            "other_description 1.2.4");
  CHECK(refusal_with_description("/types/0/@id", "bad:Absent") ==
        file + "does not register bad:Absent, which its description promises");
  CHECK(refusal_with_description("/types/0/kind", "PatternTemplate") ==
        file + "bad:other_description is registered as FeatureDetector, but its description says PatternTemplate");
  CHECK(refusal_with_description("/types/0/produces", {"bad:Other"}) ==
        file + "bad:other_description produces bad:Thing, but its description says bad:Other");
  CHECK(refusal_with_description("/types/0/consumes", {"bad:Other"}) ==
        file + "bad:other_description consumes nothing, but its description says bad:Other");
}

TEST_CASE("a plugin that registers more than its description names is refused") {
  const PluginFolder folder;
  const std::string file = folder.copy(bad_plugin("taken_name.so"));
  auto description = nlohmann::json::parse(opal::content_of(bad_plugin("taken_name.jsonld")));
  description["types"].erase(1);
  folder.write("taken_name.jsonld", description.dump());
  CHECK(refusal_of(file) == file + ": registers bad:good, which its description does not name");
}

TEST_CASE("an announced plugin is opened when something of it is made, and not before") {
  const PluginFolder folder;
  const std::string file = folder.copy(bad_plugin("good.so"));
  folder.write("good.jsonld", opal::content_of(bad_plugin("good.jsonld")));
  const auto is_open = [&] { return dlopen(file.c_str(), RTLD_NOW | RTLD_NOLOAD) != nullptr; };
  PluginRegistry registry;
  registry.announce(file);
  CHECK(registry.type("bad:good").version == "1.2.3");
  CHECK_THROWS_WITH(registry.make<opal::HypothesisScorer>("bad:good"), Catch::Contains("expected a HypothesisScorer"));
  CHECK_FALSE(is_open());
  CHECK(registry.make<FeatureDetector>("bad:good", {{"count", 7}})->detect({}).size() == 7);
  CHECK(is_open());
  CHECK(registry.make<FeatureDetector>("bad:good")->detect({}).size() == 4);
}

TEST_CASE("an announced plugin that cannot be used says why whenever something of it is made") {
  const std::string file = bad_plugin("undefined_symbol.so");
  PluginRegistry registry;
  registry.announce(file);
  registry.announce(bad_plugin("good.so"));
  for (int time = 0; time < 2; ++time)
    CHECK_THROWS_WITH(registry.make<FeatureDetector>("bad:undefined_symbol"),
                      file + ": cannot be opened: undefined symbol: opal_test_function_that_nobody_defines");
  CHECK(registry.make<FeatureDetector>("bad:good")->detect({}).size() == 4);
}

TEST_CASE("what can be told without opening a plugin is told when it is announced") {
  PluginRegistry registry;
  std::vector<std::string> refused;
  for (const std::string& message : registry.announce_all(OPAL_BAD_PLUGIN_DIR))
    refused.push_back(std::filesystem::path(message.substr(0, message.find(": "))).stem());
  CHECK(refused == std::vector<std::string>{"good_stripped", "ordinary_library", "taken_name", "wrong_api"});
}

TEST_CASE("a refused file does not keep the others of its folder out") {
  PluginRegistry registry;
  std::vector<std::string> refused;
  for (const std::string& message : registry.load_all(OPAL_BAD_PLUGIN_DIR))
    refused.push_back(std::filesystem::path(message.substr(0, message.find(": "))).stem());
  CHECK(refused == std::vector<std::string>{"good_stripped", "incomplete", "no_factory", "no_symbol",
                                            "ordinary_library", "registers_twice", "taken_name",
                                            "throws_in_registration", "undefined_symbol", "wrong_alignment",
                                            "wrong_api", "wrong_tag"});
  CHECK(registry.has("bad:good"));
  CHECK(registry.has("bad:throws_in_score"));
  CHECK_FALSE(registry.has("bad:taken_name"));
}
