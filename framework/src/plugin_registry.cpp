#include <opal/plugin/plugin_registry.hpp>

#include "plugin_library.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <variant>

namespace opal {
namespace {

namespace fs = std::filesystem;

/// In the order of PluginKind.
using AnyFactory = std::variant<Factory<FeatureDetector>, Factory<PatternTemplate>, Factory<HypothesisScorer>,
                                Factory<LogSource>, Factory<MapImporter>, Factory<ScanMatcher>, Factory<MapStore>>;

PluginKind kind_of(const AnyFactory& factory) { return static_cast<PluginKind>(factory.index()); }

template <class T>
PluginKind kind_of_interface() {
  return kind_of(AnyFactory(Factory<T>{}));
}

/// A type that can be made. The library comes first, so that it goes last: the factory is its code.
struct Entry {
  std::shared_ptr<const PluginDescriptor> library;
  RegisteredType type;
  AnyFactory factory;
};

struct Registration {
  TypeInfo info;
  AnyFactory factory;
};

/// Takes what a plugin registers, until all of it is known to be good.
class Collector final : public Registrar {
 public:
  void add(TypeInfo type, Factory<FeatureDetector> make) override { take(std::move(type), std::move(make)); }
  void add(TypeInfo type, Factory<PatternTemplate> make) override { take(std::move(type), std::move(make)); }
  void add(TypeInfo type, Factory<HypothesisScorer> make) override { take(std::move(type), std::move(make)); }
  void add(TypeInfo type, Factory<LogSource> make) override { take(std::move(type), std::move(make)); }
  void add(TypeInfo type, Factory<MapImporter> make) override { take(std::move(type), std::move(make)); }
  void add(TypeInfo type, Factory<ScanMatcher> make) override { take(std::move(type), std::move(make)); }
  void add(TypeInfo type, Factory<MapStore> make) override { take(std::move(type), std::move(make)); }

  std::vector<Registration> registrations;

 private:
  template <class T>
  void take(TypeInfo type, Factory<T> make) {
    registrations.push_back({std::move(type), std::move(make)});
  }
};

[[noreturn]] void refuse(const std::string& file, const std::string& cause) {
  throw PluginError(file + ": " + cause);
}

std::string canonical_file(const std::string& path) {
  std::error_code error;
  const fs::path canonical = fs::canonical(path, error);
  if (error) refuse(path, "there is no such file");
  if (!fs::is_regular_file(canonical)) refuse(path, "is no file");
  return canonical.string();
}

std::string description_path(const std::string& file) {
  return fs::path(file).replace_extension(".jsonld").string();
}

std::string listed(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list.empty() ? "nothing" : list;
}

void require_same_plugin(const std::string& file, const PluginDescription& promised,
                         const PluginDescriptor& actual) {
  if (promised.name == actual.name && promised.version == actual.version) return;
  refuse(file, std::string("calls itself ") + actual.name + " " + actual.version + ", but " +
                   description_path(file) + " describes " + promised.name + " " + promised.version);
}

bool same_set(std::vector<std::string> a, std::vector<std::string> b) {
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  return a == b;
}

void require_as_described(const std::string& file, const DescribedType& promised,
                          const Registration& actual) {
  const std::string name = promised.info.name;
  const auto differ = [&](const std::string& what, const std::string& is, const std::string& described) {
    refuse(file, name + " " + what + " " + is + ", but its description says " + described);
  };
  if (kind_of(actual.factory) != promised.kind)
    differ("is registered as", name_of(kind_of(actual.factory)), name_of(promised.kind));
  if (!same_set(actual.info.consumes, promised.info.consumes))
    differ("consumes", listed(actual.info.consumes), listed(promised.info.consumes));
  if (!same_set(actual.info.produces, promised.info.produces))
    differ("produces", listed(actual.info.produces), listed(promised.info.produces));
  if (std::visit([](const auto& make) { return !make; }, actual.factory))
    refuse(file, name + " is registered without a factory");
}

/// The registrations by name, when they are exactly those described.
std::map<std::string, Registration> by_name(const std::string& file, const PluginDescription& promised,
                                            std::vector<Registration> registrations) {
  std::map<std::string, Registration> named;
  for (Registration& registration : registrations) {
    const std::string name = registration.info.name;
    if (!named.emplace(name, std::move(registration)).second) refuse(file, "registers " + name + " twice");
  }
  for (const DescribedType& type : promised.types) {
    const auto found = named.find(type.info.name);
    if (found == named.end())
      refuse(file, "does not register " + type.info.name + ", which its description promises");
    require_as_described(file, type, found->second);
  }
  for (const auto& [name, ignored] : named) {
    const auto is_this = [&key = name](const DescribedType& type) { return type.info.name == key; };
    if (std::none_of(promised.types.begin(), promised.types.end(), is_this))
      refuse(file, "registers " + name + ", which its description does not name");
  }
  return named;
}

std::map<std::string, Registration> collect(const std::string& file, const PluginDescription& promised,
                                            const PluginDescriptor& plugin) {
  Collector collector;
  if (const auto failure = failure_of([&] { plugin.register_types(collector); }))
    refuse(file, "failed to register its types: " + *failure);
  return by_name(file, promised, std::move(collector.registrations));
}

}  // namespace

struct PluginRegistry::State {
  std::map<std::string, Entry> entries;

  void require_new(const std::string& file, const PluginDescription& description) const {
    for (const auto& [name, entry] : entries)
      if (entry.type.file == file) refuse(file, "is loaded already");
    for (const DescribedType& type : description.types) {
      const auto found = entries.find(type.info.name);
      if (found != entries.end())
        refuse(file, "offers " + type.info.name + ", which " + found->second.type.file + " (" +
                         found->second.type.plugin + " " + found->second.type.version + ") offers already");
    }
  }

  void merge(const std::string& file, const PluginDescription& description,
             const std::shared_ptr<const PluginDescriptor>& library,
             std::map<std::string, Registration>& named) {
    std::map<std::string, Entry> taken;
    for (const DescribedType& described : description.types) {
      RegisteredType type{described.info, described.kind,        description.name, description.version,
                          file,           described.description, described.options,   described.on_request};
      taken.emplace(described.info.name,
                    Entry{library, std::move(type), std::move(named.at(described.info.name).factory)});
    }
    entries.merge(taken);
  }

  const Entry& entry(const std::string& name) const {
    const auto found = entries.find(name);
    if (found != entries.end()) return found->second;
    std::vector<std::string> names;
    for (const auto& [known, ignored] : entries) names.push_back(known);
    throw PluginError("no plugin offers " + name + "; there is: " + listed(names));
  }
};

PluginRegistry::PluginRegistry() : state_(std::make_unique<State>()) {}
PluginRegistry::~PluginRegistry() = default;
PluginRegistry::PluginRegistry(PluginRegistry&&) noexcept = default;
PluginRegistry& PluginRegistry::operator=(PluginRegistry&&) noexcept = default;

void PluginRegistry::load(const std::string& path) {
  const std::string file = canonical_file(path);
  require_plugin_file(file);
  const PluginDescription description = read_plugin_description(description_path(file));
  state_->require_new(file, description);
  const auto library = open_plugin(file);  // from here on, code of the file runs
  require_same_plugin(file, description, *library);
  auto registrations = collect(file, description, *library);
  keep_until_exit(file);
  state_->merge(file, description, library, registrations);
}

std::vector<std::string> PluginRegistry::load_all(const std::string& folder) {
  if (!fs::is_directory(folder)) refuse(folder, "there is no such folder of plugins");
  std::vector<std::string> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".so") files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  std::vector<std::string> refusals;
  for (const std::string& file : files) {
    try {
      load(file);
    } catch (const PluginError& refusal) {
      refusals.emplace_back(refusal.what());
    }
  }
  return refusals;
}

std::vector<RegisteredType> PluginRegistry::types() const {
  std::vector<RegisteredType> types;
  for (const auto& [name, entry] : state_->entries) types.push_back(entry.type);
  return types;
}

const RegisteredType& PluginRegistry::type(const std::string& name) const { return state_->entry(name).type; }

bool PluginRegistry::has(const std::string& name) const { return state_->entries.count(name) > 0; }

template <class T>
std::shared_ptr<const T> PluginRegistry::make(const std::string& name, const nlohmann::json& options) const {
  const Entry& entry = state_->entry(name);
  const std::string origin = name + " from " + entry.type.plugin + " " + entry.type.version;
  const auto* factory = std::get_if<Factory<T>>(&entry.factory);
  if (factory == nullptr)
    throw PluginError(origin + " is a " + name_of(entry.type.kind) + ", expected a " +
                      name_of(kind_of_interface<T>()));
  const nlohmann::json complete = complete_options(name, entry.type.options, options);
  std::unique_ptr<T> made;
  if (const auto failure = failure_of([&] { made = (*factory)(complete); }))
    throw PluginError(origin + ": cannot be made: " + *failure);
  if (made == nullptr) throw PluginError(origin + ": cannot be made: its factory returned null");
  return {made.release(), [library = entry.library](const T* object) { delete object; }};
}

template std::shared_ptr<const FeatureDetector> PluginRegistry::make(const std::string&,
                                                                     const nlohmann::json&) const;
template std::shared_ptr<const PatternTemplate> PluginRegistry::make(const std::string&,
                                                                     const nlohmann::json&) const;
template std::shared_ptr<const HypothesisScorer> PluginRegistry::make(const std::string&,
                                                                      const nlohmann::json&) const;
template std::shared_ptr<const LogSource> PluginRegistry::make(const std::string&,
                                                               const nlohmann::json&) const;
template std::shared_ptr<const MapImporter> PluginRegistry::make(const std::string&,
                                                                 const nlohmann::json&) const;
template std::shared_ptr<const ScanMatcher> PluginRegistry::make(const std::string&,
                                                                 const nlohmann::json&) const;
template std::shared_ptr<const MapStore> PluginRegistry::make(const std::string&, const nlohmann::json&) const;

}  // namespace opal
