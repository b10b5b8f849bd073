#include <opal/plugin/plugin_registry.hpp>

#include "common/phrases.hpp"
#include "plugin/class_source.hpp"
#include "plugin/described_library.hpp"
#include "plugin/plugin_library.hpp"
#include "plugin/refusal.hpp"
#include "plugin/trust.hpp"

#include <algorithm>
#include <filesystem>
#include <map>

namespace opal {
namespace {

namespace fs = std::filesystem;

/// Takes every *.so of a folder, by name. @return why some were not taken.
template <class Take>
std::vector<std::string> refusals_of(const std::string& folder, const Take& take) {
  if (!fs::is_directory(folder)) refuse_file(folder, "there is no such folder of plugins");
  std::vector<std::string> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".so") files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  std::vector<std::string> refusals;
  for (const std::string& file : files) {
    try {
      take(file);
    } catch (const PluginError& refusal) {
      refusals.emplace_back(refusal.what());
    }
  }
  return refusals;
}

/// A type that can be made.
struct Entry {
  std::shared_ptr<DescribedLibrary> library;
  RegisteredType type;
};

}  // namespace

struct PluginRegistry::State {
  std::map<std::string, Entry> entries;
  std::vector<TrustedPlugins> lists;  ///< each of which must trust what is made

  void expect_trusted(const Entry& entry) const {
    for (const TrustedPlugins& trusted : lists) expect_trusted_plugin(trusted, *entry.library);
  }

  /// A type that runs a class runs code of that class's file.
  void expect_trusted_class_in(const Entry& entry, const nlohmann::json& options) const {
    if (entry.type.info.name != host_of(entry.type.kind)) return;
    for (const TrustedPlugins& trusted : lists) expect_trusted_class(trusted, options.at("class").get<std::string>());
  }

  void require_new(const DescribedLibrary& library) const {
    for (const auto& [name, entry] : entries)
      if (entry.library->file() == library.file()) refuse_file(library.file(), "is loaded already");
    for (const DescribedType& type : library.description().types) {
      const auto found = entries.find(type.info.name);
      if (found != entries.end())
        refuse_file(library.file(), "offers " + type.info.name + ", which " + found->second.type.file + " (" +
                                        found->second.type.plugin + " " + found->second.type.version +
                                        ") offers already");
    }
  }

  void merge(const std::shared_ptr<DescribedLibrary>& library) {
    const PluginDescription& description = library->description();
    for (const DescribedType& described : description.types)
      entries.emplace(described.info.name,
                      Entry{library, RegisteredType{described.info, described.kind, description.name,
                                                    description.version, library->file(), described.description,
                                                    described.options, described.on_request}});
  }

  const Entry& entry(const std::string& name) const {
    const auto found = entries.find(name);
    if (found != entries.end()) return found->second;
    std::vector<std::string> names;
    for (const auto& [known, ignored] : entries) names.push_back(known);
    throw PluginError("no plugin offers " + name + "; there is: " + listed(names, "nothing"));
  }
};

PluginRegistry::PluginRegistry() : state_(std::make_unique<State>()) {}
PluginRegistry::~PluginRegistry() = default;
PluginRegistry::PluginRegistry(PluginRegistry&&) noexcept = default;
PluginRegistry& PluginRegistry::operator=(PluginRegistry&&) noexcept = default;

void PluginRegistry::load(const std::string& path) {
  const auto library = std::make_shared<DescribedLibrary>(path);
  state_->require_new(*library);
  for (const TrustedPlugins& trusted : state_->lists) expect_trusted_plugin(trusted, *library);
  library->open();
  state_->merge(library);
}

void PluginRegistry::announce(const std::string& path) {
  const auto library = std::make_shared<DescribedLibrary>(path);
  state_->require_new(*library);
  state_->merge(library);
}

std::vector<std::string> PluginRegistry::load_all(const std::string& folder) {
  return refusals_of(folder, [this](const std::string& file) { load(file); });
}

std::vector<std::string> PluginRegistry::announce_all(const std::string& folder) {
  return refusals_of(folder, [this](const std::string& file) { announce(file); });
}

std::vector<RegisteredType> PluginRegistry::types() const {
  std::vector<RegisteredType> types;
  for (const auto& [name, entry] : state_->entries) types.push_back(entry.type);
  return types;
}

const RegisteredType& PluginRegistry::type(const std::string& name) const { return state_->entry(name).type; }

bool PluginRegistry::has(const std::string& name) const { return state_->entries.count(name) > 0; }

PluginRegistry PluginRegistry::trusting(const std::optional<TrustedPlugins>& trusted) const {
  PluginRegistry registry;
  *registry.state_ = *state_;
  std::vector<TrustedPlugins>& lists = registry.state_->lists;
  if (trusted && std::find(lists.begin(), lists.end(), *trusted) == lists.end()) lists.push_back(*trusted);
  return registry;
}

bool PluginRegistry::is_listed(const std::string& name) const {
  const std::string& plugin = type(name).plugin;
  return std::all_of(state_->lists.begin(), state_->lists.end(),
                     [&](const TrustedPlugins& trusted) { return trusted.plugins.contains(plugin); });
}

void PluginRegistry::expect_trusted(const std::string& name) const { state_->expect_trusted(state_->entry(name)); }

template <class T>
std::shared_ptr<const T> PluginRegistry::make(const std::string& name, const nlohmann::json& options) const {
  const Entry& entry = state_->entry(name);
  const std::string origin = name + " from " + entry.type.plugin + " " + entry.type.version;
  if (entry.type.kind != kind_of_interface<T>())
    throw PluginError(origin + " is a " + name_of(entry.type.kind) + ", expected a " + name_of(kind_of_interface<T>()));
  const nlohmann::json complete = complete_options(name, entry.type.options, options);
  state_->expect_trusted(entry);
  state_->expect_trusted_class_in(entry, complete);
  entry.library->open();
  const auto& factory = std::get<Factory<T>>(entry.library->factory(name));
  std::unique_ptr<T> made;
  if (const auto failure = failure_of([&] { made = factory(complete); }))
    throw PluginError(origin + ": cannot be made: " + *failure);
  if (made == nullptr) throw PluginError(origin + ": cannot be made: its factory returned null");
  return {made.release(), [library = entry.library](const T* object) { delete object; }};
}

template std::shared_ptr<const FeatureDetector> PluginRegistry::make(const std::string&, const nlohmann::json&) const;
template std::shared_ptr<const PatternTemplate> PluginRegistry::make(const std::string&, const nlohmann::json&) const;
template std::shared_ptr<const HypothesisScorer> PluginRegistry::make(const std::string&, const nlohmann::json&) const;
template std::shared_ptr<const LogSource> PluginRegistry::make(const std::string&, const nlohmann::json&) const;
template std::shared_ptr<const MapImporter> PluginRegistry::make(const std::string&, const nlohmann::json&) const;
template std::shared_ptr<const ScanMatcher> PluginRegistry::make(const std::string&, const nlohmann::json&) const;
template std::shared_ptr<const MapStore> PluginRegistry::make(const std::string&, const nlohmann::json&) const;

}  // namespace opal
