#include "glass.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace opal::ifc_importer {
namespace {

using Words = std::vector<std::string>;

// Words of English, German, Dutch, French and Spanish.
constexpr std::array<std::string_view, 6> kBegins{"glass", "glas", "glaz", "vitr", "vidrio", "verre"};
constexpr std::array<std::string_view, 2> kEnds{"glass", "glas"};
constexpr std::array<std::string_view, 3> kWithin{"verglas", "vitrage", "beglaz"};
// These begin or end like glass.
constexpr std::array<std::string_view, 6> kOthers{"dougl", "glasgow", "glasur", "glasier", "vitrif", "vitreous"};
// Of these, glass is a part that nobody looks through.
constexpr std::array<std::string_view, 13> kOpaque{"wool",  "wolle",  "glaswol",  "fibre", "fiber",
                                                   "faser", "tapete", "gewebe",   "vlies", "schaum",
                                                   "foam",  "reinfo", "wallpaper"};
// The same, as whole words.
constexpr std::array<std::string_view, 3> kOpaqueWords{"laine", "toile", "lana"};
// What is glazed with these is no pane.
constexpr std::array<std::string_view, 7> kCeramic{"tile",    "brick",  "ceramic",   "keramik",
                                                   "klinker", "fliese", "terracotta"};
constexpr std::array<std::string_view, 5> kAir{"air", "luft", "argon", "cavity", "gas"};

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || static_cast<signed char>(c) < 0; }

Words words_of(const std::string& text) {
  Words words(1);
  for (const char c : text) {
    if (is_letter(c))
      words.back() += c;
    else if (!words.back().empty())
      words.emplace_back();
  }
  return words;
}

template <std::size_t N>
bool begins(const std::string& word, const std::array<std::string_view, N>& parts) {
  return std::ranges::any_of(parts, [&](std::string_view part) { return word.starts_with(part); });
}

template <std::size_t N>
bool holds(const std::string& word, const std::array<std::string_view, N>& parts) {
  return std::ranges::any_of(parts, [&](std::string_view part) { return word.find(part) != std::string::npos; });
}

bool is_opaque(const std::string& word) {
  return holds(word, kOpaque) ||
         std::ranges::any_of(kOpaqueWords, [&](std::string_view other) { return word == other; });
}

bool is_word_of_glass(const std::string& word) {
  if (begins(word, kOthers)) return false;
  return begins(word, kBegins) || holds(word, kWithin) ||
         std::ranges::any_of(kEnds, [&](std::string_view part) { return word.ends_with(part); });
}

bool is_air(const std::string& material) {
  const Words words = words_of(material);
  return material.empty() || std::ranges::any_of(words, [](const std::string& word) {
           return std::ranges::any_of(kAir, [&](std::string_view air) { return word == air; }) ||
                  word.starts_with("luft");
         });
}

bool is_glass_by_layers(const Element& element) {
  double glass_m = 0, all_m = 0;
  for (const Material& layer : element.materials) {
    if (layer.thickness_m == 0 || is_air(layer.name)) continue;
    all_m += layer.thickness_m;
    if (speaks_of_glass(layer.name)) glass_m += layer.thickness_m;
  }
  return glass_m > all_m / 2;
}

bool is_glass_by_materials(const Element& element) {
  const auto glass = std::ranges::count_if(element.materials, [](const Material& material) {
    return material.thickness_m == 0 && speaks_of_glass(material.name);
  });
  const auto all =
      std::ranges::count_if(element.materials, [](const Material& material) { return material.thickness_m == 0; });
  return glass > 0 && 2 * glass >= all;
}

}  // namespace

bool speaks_of_glass(const std::string& text) {
  const Words words = words_of(text);
  if (std::ranges::any_of(words, is_opaque)) return false;
  const bool is_ceramic = std::ranges::any_of(words, [](const std::string& word) { return begins(word, kCeramic); });
  return std::ranges::any_of(words, [&](const std::string& word) {
    return is_word_of_glass(word) && !(is_ceramic && word.starts_with("glaz"));
  });
}

bool is_glass(const Element& element) {
  if (std::ranges::any_of(element.words, speaks_of_glass)) return true;
  if (element.is_a("IfcPlate"))
    return std::ranges::any_of(element.materials,
                               [](const Material& material) { return speaks_of_glass(material.name); });
  return is_glass_by_layers(element) || is_glass_by_materials(element);
}

}  // namespace opal::ifc_importer
