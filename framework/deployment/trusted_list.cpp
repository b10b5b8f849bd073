#include "deployment/trusted_list.hpp"

#include "plugin/trust.hpp"

#include <algorithm>

namespace opal {
namespace {

bool is_sha256(const std::string& text) {
  const auto is_hex = [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); };
  return text.size() == 64 && std::all_of(text.begin(), text.end(), is_hex);
}

TrustedFile trusted_file(ConfigObject& object, const char* key) {
  const std::string sha256 = object.required_text(key);
  if (!is_sha256(sha256)) object.refuse(key, "64 hexadecimal digits, 0-9 and a-f");
  return {sha256, object.where(key)};
}

/// A plugin's library by the plugin's name, with its description if that has a digest; or a file of classes by its
/// path.
void read_trusted(ConfigObject object, const std::string& document, TrustedPlugins& trusted) {
  const std::string plugin = object.text("plugin", ""), file = object.text("file", "");
  if (plugin.empty() == file.empty()) object.refuse("plugin", "either the name of a plugin or a \"file\" of classes");
  const TrustedFile trusted_as = trusted_file(object, "sha256");
  if (!plugin.empty() && !object.any("description_sha256").is_null())
    trusted.descriptions.emplace(plugin, trusted_file(object, "description_sha256"));
  object.expect_no_more();
  const char* key = file.empty() ? "plugin" : "file";
  auto& known = file.empty() ? trusted.plugins : trusted.class_files;
  const std::string name = file.empty() ? plugin : class_file_key(beside(document, file));
  if (!known.emplace(name, trusted_as).second)
    object.refuse(key, std::string("a ") + key + " that is not in the list already");
}

}  // namespace

std::optional<TrustedPlugins> read_trusted_plugins(ConfigObject& document, const std::string& file) {
  const auto objects = document.list("trusted_plugins");
  if (!objects) return std::nullopt;
  TrustedPlugins trusted{document.where("trusted_plugins"), {}, {}, {}};
  for (const ConfigObject& object : *objects) read_trusted(object, file, trusted);
  return trusted;
}

PluginRegistry trusted_by(const Deployment& deployment, const PluginRegistry& registry) {
  return registry.trusting(deployment.trusted_plugins);
}

}  // namespace opal
