// The dynamic loader dies of SIGBUS on a library that lacks its end: it must never get to see one.
#include "plugin_files.hpp"

#include "tests/kit/refusal.hpp"

#include <opal/plugin/plugin_registry.hpp>

#include <catch2/catch.hpp>

#include <random>
#include <vector>

using opal_test::bad_plugin;
using opal_test::PluginFolder;

namespace {

std::string refusal_of_fresh(const std::string& path) {
  opal::PluginRegistry registry;
  return opal::refused_with<opal::PluginError>([&] { registry.load(path); });
}

}  // namespace

TEST_CASE("a plugin that lacks its end is refused, wherever it is cut") {
  const PluginFolder folder;
  folder.copy(bad_plugin("good.jsonld"));
  const std::string whole = opal::content_of(bad_plugin("good.so"));
  std::vector<std::size_t> lengths{0, 1, 4, 15, 63, 64, 65, 1000, whole.size() / 2, whole.size() - 1};
  for (std::size_t length = 2000; length < whole.size(); length += whole.size() / 40) lengths.push_back(length);
  for (const std::size_t length : lengths) {
    CAPTURE(length, whole.size());
    const std::string file = folder.write("good.so", whole.substr(0, length));
    const std::string refusal = refusal_of_fresh(file);
    CHECK_THAT(refusal, Catch::StartsWith(file + ": is "));
    CHECK_THAT(refusal, Catch::Contains(length < 4 ? "does not begin with the ELF magic number" : "is truncated: "));
  }
}

TEST_CASE("a plugin whose section headers cannot be right is refused or loaded, but never kills the process") {
  const PluginFolder folder;
  folder.copy(bad_plugin("good.jsonld"));
  const std::string whole = opal::content_of(bad_plugin("good.so"));
  const unsigned seed = 7;
  CAPTURE(seed);
  std::mt19937 random(seed);
  // Bytes of the ELF header: e_type; e_shoff; e_phentsize; e_shentsize, e_shnum and e_shstrndx. What is in
  // range but wrong in the program headers only the loader could tell.
  const std::vector<std::size_t> places{16, 17, 40, 41, 42, 43, 44, 45, 46, 47, 54, 55, 58, 59, 60, 61, 62, 63};
  for (int trial = 0; trial < 200; ++trial) {
    std::string damaged = whole;
    const std::size_t place = places[random() % places.size()];
    damaged[place] = static_cast<char>(random());
    CAPTURE(place, static_cast<int>(damaged[place]));
    const std::string refusal = refusal_of_fresh(folder.write("good.so", damaged));
    CHECK((refusal == "accepted" || refusal.find("good.so: ") != std::string::npos));
  }
}
