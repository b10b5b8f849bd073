#include <opal/common/error.hpp>
#include <opal/common/strict_json.hpp>
#include <opal/deployment/deployment.hpp>
#include "common/digest/sha256.hpp"
#include "deployment/class_files.hpp"
#include "deployment/types_made.hpp"
#include "deployment_text.hpp"
#include "jsonld/json_ld.hpp"
#include "tests/kit/refusal.hpp"

#include <catch2/catch.hpp>

#include <filesystem>

using namespace opal;
using Catch::Contains;
using Catch::StartsWith;
using nlohmann::json;

namespace {

const std::string kDigest(64, 'a');

json entry(const char* key, const std::string& name, const std::string& digest = kDigest) {
  return {{key, name}, {"sha256", digest}};
}

template <class... Entries>
std::string list_of(const Entries&... entries) {
  return json::array({entries...}).dump();
}

/// The message after the file's name.
std::string list_refusal(const std::string& list) {
  return refused_with<ConfigError>([&] { parsed("\"trusted_plugins\": " + list); }, kFile);
}

PluginRegistry announced() {
  PluginRegistry registry;
  for (const std::string& refusal : registry.announce_all(OPAL_PLUGIN_DIR)) FAIL(refusal);
  return registry;
}

/// Two walls that meet.
std::shared_ptr<const SemanticMap> corner() {
  return SemanticMap::make(
      "room", {{"south", "opal:Wall", {MapFeatureNumber(0)}}, {"east", "opal:Wall", {MapFeatureNumber(1)}}},
      {{"south/face", MapObjectNumber(0), "opal:Wall", "PlanarLidar2D", Segment{{0, 0}, {20, 0}}, 0, 1, {}},
       {"east/face", MapObjectNumber(1), "opal:Wall", "PlanarLidar2D", Segment{{20, 0}, {20, 10}}, 0, 1, {}}});
}

const std::string kMembers = R"("matcher": {"@type": "opal:PointToLineMatcher"})";

/// What runs on the corner, as it is.
std::map<std::string, std::string> digests(const PluginRegistry& registry) {
  std::map<std::string, std::string> digests;
  for (const std::string& type : types_made(parsed(kMembers), registry, *corner()))
    digests[registry.type(type).plugin] = sha256_of_file(registry.type(type).file);
  return digests;
}

std::string trust_refusal(const std::map<std::string, std::string>& digests) {
  json list = json::array();
  for (const auto& [plugin, digest] : digests) list.push_back(entry("plugin", plugin, digest));
  return refused_with<ConfigError>(
      [&] { build_parts(parsed(kMembers + ", \"trusted_plugins\": " + list.dump()), announced(), corner()); });
}

}  // namespace

TEST_CASE("trusted plugins and files of classes are read with the place of each digest") {
  const auto trusted =
      parsed("\"trusted_plugins\": " + list_of(entry("plugin", "lines"), entry("file", "../x/acme.py")))
          .trusted_plugins;
  REQUIRE(trusted.has_value());
  CHECK(trusted->where == kFile + ": /trusted_plugins");
  CHECK(trusted->plugins.at("lines") == TrustedFile{kDigest, kFile + ": /trusted_plugins/0/sha256"});
  const std::string file = std::filesystem::weakly_canonical(std::filesystem::absolute("configs/../x/acme.py"));
  CHECK(trusted->class_files.at(file) == TrustedFile{kDigest, kFile + ": /trusted_plugins/1/sha256"});
  CHECK_FALSE(parsed("").trusted_plugins.has_value());
  CHECK(parsed("\"trusted_plugins\": []").trusted_plugins.has_value());
}

TEST_CASE("a trusted plugin may come with the digest of its description") {
  json with = entry("plugin", "lines"), without = entry("plugin", "circles");
  with["description_sha256"] = std::string(64, 'b');
  const auto trusted = parsed("\"trusted_plugins\": " + list_of(with, without)).trusted_plugins;
  REQUIRE(trusted->descriptions.size() == 1);
  CHECK(trusted->descriptions.at("lines") ==
        TrustedFile{std::string(64, 'b'), kFile + ": /trusted_plugins/0/description_sha256"});
  with["description_sha256"] = "b";
  CHECK(list_refusal(list_of(with)) ==
        "/trusted_plugins/0/description_sha256: \"b\", expected 64 hexadecimal digits, 0-9 and a-f");
  json of_file = entry("file", "a.py");
  of_file["description_sha256"] = kDigest;
  CHECK_THAT(list_refusal(list_of(of_file)), StartsWith("/trusted_plugins/0/description_sha256: unknown key"));
}

TEST_CASE("a list of trusted plugins that is malformed is refused with its place") {
  const std::string expected = ", expected 64 hexadecimal digits, 0-9 and a-f";
  for (const std::string& digest :
       {std::string(63, 'a'), std::string(65, 'a'), std::string(64, 'A'), std::string(63, 'a') + "g"})
    CHECK(list_refusal(list_of(entry("plugin", "lines", digest))) ==
          "/trusted_plugins/0/sha256: \"" + digest + "\"" + expected);
  CHECK(list_refusal(R"([{"plugin": "a"}])") == "/trusted_plugins/0/sha256: absent, expected a text");
  CHECK(list_refusal(R"([{"plugin": "a", "sha256": 3}])") == "/trusted_plugins/0/sha256: 3, expected a text");
  CHECK_THAT(list_refusal(R"([{"sha256": "0"}])"), StartsWith("/trusted_plugins/0/plugin: absent, expected either"));
  CHECK_THAT(list_refusal(R"([{"plugin": "a", "file": "a.py"}])"),
             StartsWith("/trusted_plugins/0/plugin: \"a\", expected either"));
  CHECK(list_refusal(list_of(entry("plugin", "a"), entry("plugin", "a"))) ==
        "/trusted_plugins/1/plugin: \"a\", expected a plugin that is not in the list already");
  CHECK(list_refusal(list_of(entry("file", "a.py"), entry("file", "./a.py"))) ==
        "/trusted_plugins/1/file: \"./a.py\", expected a file that is not in the list already");
  json unknown = entry("plugin", "a");
  unknown["sha1"] = "";
  CHECK_THAT(list_refusal(list_of(unknown)), StartsWith("/trusted_plugins/0/sha1: unknown key"));
  CHECK_THAT(list_refusal("\"lines\""), StartsWith("/trusted_plugins: \"lines\", expected a list"));
}

TEST_CASE("parts are built of trusted plugins, and of no others") {
  const auto right = digests(announced());
  REQUIRE(right.contains("lines"));
  REQUIRE(right.contains("score_beams"));
  CHECK(trust_refusal(right) == "accepted");
  for (const auto& [plugin, digest] : right) {
    auto wrong = right;
    wrong[plugin] = kDigest;
    CHECK_THAT(trust_refusal(wrong), StartsWith(kFile + ": /trusted_plugins/") &&
                                         Contains("/sha256: plugin " + plugin + ": ") &&
                                         Contains(" has SHA-256 " + digest + ", expected " + kDigest));
    wrong.erase(plugin);
    CHECK_THAT(trust_refusal(wrong), StartsWith(kFile + ": /trusted_plugins: plugin " + plugin + ": ") &&
                                         Contains(digest + " and is not in the list"));
  }
}

TEST_CASE("parts that are listed are checked against the trusted plugins before there is a map") {
  const Deployment deployment = parsed("\"trusted_plugins\": " + list_of(entry("plugin", "score_beams")));
  CHECK_THROWS_WITH(check_parts(deployment, announced()), Contains("plugin score_beams") && Contains(kDigest));
  const Deployment importing = parsed(R"("importers": [{"@type": "opal:GridImporter"}], "trusted_plugins": [])");
  CHECK_THROWS_WITH(importer_options(importing, announced(), "opal:GridImporter"),
                    Contains("plugin grid_importer") && Contains("is not in the list"));
}

TEST_CASE("trusted files of classes go with the classes when these get other names") {
  json deployment{{"scorers", {{{"@type", "a/b.py:C"}}}}};
  deployment["trusted_plugins"] = json::array({entry("file", "a/b.py"), entry("plugin", "python")});
  const json named = with_classes_named(
      deployment, [](const ClassSource& source) { return "classes/" + source.file + ":" + source.name; });
  CHECK(named["scorers"][0]["@type"] == "classes/a/b.py:C");
  CHECK(named["trusted_plugins"] == json::array({entry("file", "classes/a/b.py"), entry("plugin", "python")}));
}

TEST_CASE("a deployment with trusted plugins is JSON-LD of Opal's vocabulary") {
  json_ld::Options options;
  options.contexts["urn:opal:v1"] = read_json(OPAL_SOURCE_DIR "/maps/context/opal.jsonld");
  options.reject_unknown_terms = true;
  const json list = json::array({entry("plugin", "lines"), entry("file", "acme.py")});
  const json expanded = json_ld::expand(parse_json(document("\"trusted_plugins\": " + list.dump()), kFile), options);
  CHECK(expanded[0]["urn:opal:v1#trusted_plugins"][0]["@value"] == list);
}
