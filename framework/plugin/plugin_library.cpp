#include "plugin/plugin_library.hpp"

#include "plugin/elf_check.hpp"
#include "plugin/refusal.hpp"

#include <vector>  // library_info.hpp of Boost 1.74 misses it under BOOST_DLL_USE_STD_FS

#include <dlfcn.h>
#include <boost/dll/library_info.hpp>
#include <boost/dll/shared_library.hpp>

#include <algorithm>
#include <cctype>

namespace opal {
namespace {

constexpr const char* kSymbol = "opal_plugin_v1";
constexpr const char* kSection = "opal_v1";
constexpr const char* kApi = "1";

std::vector<std::string> sections_of(const std::string& file) {
  std::vector<std::string> sections;
  const auto failure = failure_of([&] { sections = boost::dll::library_info(file).sections(); });
  if (failure) refuse_file(file, "its sections cannot be read (" + *failure + ")");
  return sections;
}

/// The API that a section name stands for: "2" for "opal_v2"; empty for any other section.
std::string api_of(const std::string& section) {
  const std::string prefix = "opal_v";
  if (section.size() <= prefix.size() || section.compare(0, prefix.size(), prefix) != 0) return {};
  const std::string number = section.substr(prefix.size());
  const bool digits = std::all_of(number.begin(), number.end(), [](unsigned char c) { return std::isdigit(c); });
  return digits ? number : std::string{};
}

/// What the dynamic loader says (Boost.DLL says "Bad file descriptor" of every cause), without the file's
/// name.
std::string loader_error(const std::string& file) {
  const char* said = dlerror();
  const std::string text = said == nullptr ? "unknown cause" : said;
  const std::string prefix = file + ": ";
  return text.compare(0, prefix.size(), prefix) == 0 ? text.substr(prefix.size()) : text;
}

void require_same_abi(const std::string& file, const PluginDescriptor& descriptor) {
  const std::string tag = descriptor.abi_tag == nullptr ? "none" : descriptor.abi_tag;
  if (tag == kAbiTag && descriptor.eigen_max_align == EIGEN_MAX_ALIGN_BYTES) return;
  refuse_file(file, "was built for \"" + tag + " eigen_align=" + std::to_string(descriptor.eigen_max_align) +
                        "\", this is \"" + kAbiTag + " eigen_align=" + std::to_string(EIGEN_MAX_ALIGN_BYTES) +
                        "\"; build it anew against the headers of this Opal, with its compiler and flags");
}

void require_complete(const std::string& file, const PluginDescriptor& descriptor) {
  if (descriptor.name == nullptr || descriptor.version == nullptr || descriptor.register_types == nullptr)
    refuse_file(file, "its descriptor lacks a name, a version or a function that registers types");
}

}  // namespace

void require_plugin_file(const std::string& file) {
  const std::string defect = elf_defect(file);
  if (!defect.empty()) refuse_file(file, defect);
  const std::vector<std::string> sections = sections_of(file);
  if (std::find(sections.begin(), sections.end(), kSection) != sections.end()) return;
  for (const std::string& section : sections) {
    const std::string api = api_of(section);
    if (!api.empty()) refuse_file(file, "was built for plugin API " + api + ", this is " + kApi);
  }
  refuse_file(file, std::string("is no Opal plugin: it has no section ") + kSection);
}

std::shared_ptr<const PluginDescriptor> open_plugin(const std::string& file) {
  const auto library = std::make_shared<boost::dll::shared_library>();
  std::error_code error;
  library->load(file, error, boost::dll::load_mode::rtld_now | boost::dll::load_mode::rtld_local);
  if (error) refuse_file(file, "cannot be opened: " + loader_error(file));
  if (!library->has(kSymbol))
    refuse_file(file, std::string("has a section ") + kSection + ", but no symbol " + kSymbol);
  const PluginDescriptor& descriptor = library->get_alias<const PluginDescriptor>(kSymbol);
  require_same_abi(file, descriptor);
  require_complete(file, descriptor);
  return {library, &descriptor};
}

void keep_until_exit(const std::string& file) {
  void* again = dlopen(file.c_str(), RTLD_NOW | RTLD_NOLOAD | RTLD_NODELETE);
  if (again != nullptr) dlclose(again);
}

}  // namespace opal
