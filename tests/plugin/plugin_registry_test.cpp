// What needs no plugin. tests/plugin/bad_plugins has the plugins that fail, tests/plugin/contract those that must not.
#include "tests/kit/temporary_folder.hpp"

#include <opal/plugin/plugin_folders.hpp>
#include <opal/plugin/plugin_registry.hpp>

#include <catch2/catch.hpp>

#include <cstdlib>

TEST_CASE("a new registry offers nothing, and says so") {
  const opal::PluginRegistry registry;
  CHECK(registry.types().empty());
  CHECK_FALSE(registry.has("opal:LineDetector"));
  CHECK_THROWS_WITH(registry.type("opal:LineDetector"), "no plugin offers opal:LineDetector; there is: nothing");
  CHECK_THROWS_AS(registry.make<opal::LogSource>("opal:CarmenLog"), opal::PluginError);
}

TEST_CASE("a folder of plugins that is not there is an error, an empty one is not") {
  opal::PluginRegistry registry;
  CHECK_THROWS_WITH(registry.load_all("/nowhere/plugins"), "/nowhere/plugins: there is no such folder of plugins");
  const opal::TemporaryFolder folder;
  CHECK(registry.load_all(folder.path()).empty());
}

TEST_CASE("plugin folders are the program's own, then those in OPAL_PLUGIN_PATH, each once") {
  setenv("OPAL_PLUGIN_PATH", "/opt/acme/plugins::/opt/acme/../acme/plugins:/opt/other", 1);
  const std::vector<std::string> folders = opal::plugin_folders();
  unsetenv("OPAL_PLUGIN_PATH");
  CHECK(folders == std::vector<std::string>{opal::own_plugin_folder(), "/opt/acme/plugins", "/opt/other"});
  CHECK(opal::plugin_folders().size() == 1);
}
