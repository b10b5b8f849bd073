#include "plugin/described_library.hpp"

#include "common/digest/sha256.hpp"
#include "common/phrases.hpp"
#include "plugin/plugin_library.hpp"
#include "plugin/refusal.hpp"

#include <algorithm>
#include <filesystem>

namespace opal {
namespace {

namespace fs = std::filesystem;

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

  std::vector<TypeRegistration> registrations;

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

void require_same_plugin(const std::string& file, const PluginDescription& promised, const PluginDescriptor& actual) {
  if (promised.name == actual.name && promised.version == actual.version) return;
  refuse_file(file, std::string("calls itself ") + actual.name + " " + actual.version + ", but " +
                        description_file(file) + " describes " + promised.name + " " + promised.version);
}

bool same_set(std::vector<std::string> a, std::vector<std::string> b) {
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  return a == b;
}

void require_as_described(const std::string& file, const DescribedType& promised, const TypeRegistration& actual) {
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
std::map<std::string, TypeRegistration> by_name(const std::string& file, const PluginDescription& promised,
                                                std::vector<TypeRegistration> registrations) {
  std::map<std::string, TypeRegistration> named;
  for (TypeRegistration& registration : registrations) {
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

std::map<std::string, TypeRegistration> collect(const std::string& file, const PluginDescription& promised,
                                                const PluginDescriptor& plugin) {
  Collector collector;
  if (const auto failure = failure_of([&] { plugin.register_types(collector); }))
    refuse_file(file, "failed to register its types: " + *failure);
  return by_name(file, promised, std::move(collector.registrations));
}

}  // namespace

std::string description_file(const std::string& library) {
  return fs::path(library).replace_extension(".jsonld").string();
}

DescribedLibrary::DescribedLibrary(const std::string& path) : file_(canonical_file(path)) {
  require_plugin_file(file_);
  description_ = read_plugin_description(description_file(file_));
}

std::string DescribedLibrary::digest() {
  const std::lock_guard lock(opening_);
  if (code_ == nullptr || digest_.empty()) digest_ = sha256_of_file(file_);
  return digest_;
}

void DescribedLibrary::open() {
  const std::lock_guard lock(opening_);
  if (code_ != nullptr) return;
  auto code = open_plugin(file_);
  require_same_plugin(file_, description_, *code);
  registered_ = collect(file_, description_, *code);
  keep_until_exit(file_);
  code_ = std::move(code);
}

}  // namespace opal
