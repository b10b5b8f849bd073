#pragma once

#include <opal/plugin/plugin.hpp>
#include <opal/plugin/plugin_description.hpp>

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <variant>

namespace opal {

/// In the order of PluginKind.
using AnyFactory = std::variant<Factory<FeatureDetector>, Factory<PatternTemplate>, Factory<HypothesisScorer>,
                                Factory<LogSource>, Factory<MapImporter>, Factory<ScanMatcher>, Factory<MapStore>>;

inline PluginKind kind_of(const AnyFactory& factory) { return static_cast<PluginKind>(factory.index()); }
template <class T>
PluginKind kind_of_interface() {
  return kind_of(AnyFactory(Factory<T>{}));
}

/// A type as the code of its plugin registers it.
struct TypeRegistration {
  TypeInfo info;
  AnyFactory factory;
};

/// Where the description of a plugin stands: beside its library.
OPAL_EXPORT std::string description_file(const std::string& library);

/// A plugin by what its description promises. No code of it runs before it is opened.
class DescribedLibrary {
 public:
  /// @throws PluginError if the file is no plugin for this framework, or has no good description.
  explicit DescribedLibrary(const std::string& path);

  const std::string& file() const { return file_; }
  const PluginDescription& description() const { return description_; }

  /// SHA-256 of the file as it is now; once the library is open, what was found at the last question before, or else at
  /// the first one after that.
  std::string digest();

  /// Loads the code, at the first call. @throws PluginError, at every call, if it cannot or is not what was promised.
  void open();

  /// Of an open library.
  const AnyFactory& factory(const std::string& type) const { return registered_.at(type).factory; }

 private:
  std::string file_;
  PluginDescription description_;
  std::mutex opening_;
  std::string digest_;
  std::shared_ptr<const PluginDescriptor>
      code_;  // before the factories, which are its code, so that it goes after them
  std::map<std::string, TypeRegistration> registered_;
};

}  // namespace opal
