#include <opal/plugin/plugin_registry.hpp>

#include "common/phrases.hpp"
#include "plugin/plugin_library.hpp"
#include "plugin/refusal.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <mutex>
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

std::string canonical_file(const std::string& path) {
  std::error_code error;
  const fs::path canonical = fs::canonical(path, error);
  if (error) refuse_file(path, "there is no such file");
  if (!fs::is_regular_file(canonical)) refuse_file(path, "is no file");
  return canonical.string();
}

std::string description_path(const std::string& file) { return fs::path(file).replace_extension(".jsonld").string(); }

void require_same_plugin(const std::string& file, const PluginDescription& promised, const PluginDescriptor& actual) {
  if (promised.name == actual.name && promised.version == actual.version) return;
  refuse_file(file, std::string("calls itself ") + actual.name + " " + actual.version + ", but " +
                        description_path(file) + " describes " + promised.name + " " + promised.version);
}

bool same_set(std::vector<std::string> a, std::vector<std::string> b) {
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  return a == b;
}

void require_as_described(const std::string& file, const DescribedType& promised, const Registration& actual) {
  const std::string name = promised.info.name;
  const auto differ = [&](const std::string& what, const std::string& is, const std::string& described) {
    refuse_file(file, name + " " + what + " " + is + ", but its description says " + described);
  };
  if (kind_of(actual.factory) != promised.kind)
    differ("is registered as", name_of(kind_of(actual.factory)), name_of(promised.kind));
  if (!same_set(actual.info.consumes, promised.info.consumes))
    differ("consumes", listed(actual.info.consumes, "nothing"), listed(promised.info.consumes, "nothing"));
  if (!same_set(actual.info.produces, promised.info.produces))
    differ("produces", listed(actual.info.produces, "nothing"), listed(promised.info.produces, "nothing"));
  if (std::visit([](const auto& make) { return !make; }, actual.factory))
    refuse_file(file, name + " is registered without a factory");
}

/// The registrations by name, when they are exactly those described.
std::map<std::string, Registration> by_name(const std::string& file, const PluginDescription& promised,
                                            std::vector<Registration> registrations) {
  std::map<std::string, Registration> named;
  for (Registration& registration : registrations) {
    const std::string name = registration.info.name;
    if (!named.emplace(name, std::move(registration)).second) refuse_file(file, "registers " + name + " twice");
  }
  for (const DescribedType& type : promised.types) {
    const auto found = named.find(type.info.name);
    if (found == named.end())
      refuse_file(file, "does not register " + type.info.name + ", which its description promises");
    require_as_described(file, type, found->second);
  }
  for (const auto& [name, ignored] : named) {
    const auto is_this = [&key = name](const DescribedType& type) { return type.info.name == key; };
    if (std::none_of(promised.types.begin(), promised.types.end(), is_this))
      refuse_file(file, "registers " + name + ", which its description does not name");
  }
  return named;
}

std::map<std::string, Registration> collect(const std::string& file, const PluginDescription& promised,
                                            const PluginDescriptor& plugin) {
  Collector collector;
  if (const auto failure = failure_of([&] { plugin.register_types(collector); }))
    refuse_file(file, "failed to register its types: " + *failure);
  return by_name(file, promised, std::move(collector.registrations));
}

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

/// A plugin by what its description promises. No code of it runs before it is opened.
class Library {
 public:
  /// @throws PluginError if the file is no plugin for this framework, or has no good description.
  explicit Library(const std::string& path) : file_(canonical_file(path)) {
    require_plugin_file(file_);
    description_ = read_plugin_description(description_path(file_));
  }

  const std::string& file() const { return file_; }
  const PluginDescription& description() const { return description_; }

  /// Loads the code, at the first call. @throws PluginError, at every call, if it cannot or is not what was promised.
  void open() {
    const std::lock_guard lock(opening_);
    if (code_ != nullptr) return;
    auto code = open_plugin(file_);
    require_same_plugin(file_, description_, *code);
    registered_ = collect(file_, description_, *code);
    keep_until_exit(file_);
    code_ = std::move(code);
  }

  /// Of an open library.
  const AnyFactory& factory(const std::string& type) const { return registered_.at(type).factory; }

 private:
  std::string file_;
  PluginDescription description_;
  std::mutex opening_;
  std::shared_ptr<const PluginDescriptor>
      code_;  // before the factories, which are its code, so that it goes after them
  std::map<std::string, Registration> registered_;
};

/// A type that can be made.
struct Entry {
  std::shared_ptr<Library> library;
  RegisteredType type;
};

}  // namespace

struct PluginRegistry::State {
  std::map<std::string, Entry> entries;

  void require_new(const Library& library) const {
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

  void merge(const std::shared_ptr<Library>& library) {
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
  const auto library = std::make_shared<Library>(path);
  state_->require_new(*library);
  library->open();
  state_->merge(library);
}

void PluginRegistry::announce(const std::string& path) {
  const auto library = std::make_shared<Library>(path);
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

template <class T>
std::shared_ptr<const T> PluginRegistry::make(const std::string& name, const nlohmann::json& options) const {
  const Entry& entry = state_->entry(name);
  const std::string origin = name + " from " + entry.type.plugin + " " + entry.type.version;
  if (entry.type.kind != kind_of_interface<T>())
    throw PluginError(origin + " is a " + name_of(entry.type.kind) + ", expected a " + name_of(kind_of_interface<T>()));
  const nlohmann::json complete = complete_options(name, entry.type.options, options);
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
