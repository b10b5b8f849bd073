#include "layer_classes.hpp"

#include "layer_words.hpp"

#include <opal/common/letter_case.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace opal::dxf_importer {
namespace {

// By the US National CAD Standard (AIA; "PLAN$0$A-WALL" in a bound reference), ISO 13567 with SfB elements, and plain
// words.
constexpr std::array kWalls{"*-WALL*", "WALL*",     "*_WALL*",    "*WALLS",  "*MUREN*", "*WAND",   "*WAENDE*", "A-21*",
                            "A-22*",   "*MAUER*",   "*WÄNDE*",    "*Wände*", "MURS*",   "MURO*",   "MURI*",    "MUR",
                            "PARED*",  "*CLOISON*", "PARTITION*", "WAND*",   "*_WAND*", "*-WAND*", "*.WALL*"};
constexpr std::array kColumns{"*-COLS*",  "*COLUMN*", "*KOLOM*", "*STUETZE*",
                              "*STÜTZE*", "*POTEAU*", "PILLAR*", "A-28*"};
constexpr std::array kDoors{"*-DOOR*", "*DOORS",  "DOOR*",    "*DEUREN*", "*TUEREN*",
                            "*TÜREN*", "PORTES*", "PUERTAS*", "A-32*"};
constexpr std::array kWindows{"*-GLAZ*",  "*WINDOW*",  "GLAZ*",     "*FENSTER*",
                              "*KOZIJN*", "*FENETRE*", "VENTANAS*", "A-31*"};
// Codes of elements (SfB), which others use for something else: "A-320G - Permanent Solid Partitions".
constexpr std::array kCodes{"A-21*", "A-22*", "A-28*", "A-31*", "A-32*"};
// What is written beside walls, lies above the cut or below the floor.
constexpr std::array kLeftOut{"*STEM-WALL*",  "*-WALL-HEAD*", "*-WALL-CNTR*", "*-WALL-IDEN*", "*-WALL-ABOV*",
                              "*-COLS-GRID*", "*-COLS-IDEN*", "*-DOOR-IDEN*", "*-GLAZ-IDEN*"};
// These words say more about a layer than "wall" or "column" beside them.
constexpr std::array kNoParts{
    "*GRID*",      "*RASTER*",   "*AXE*",        "*AXIS*",      "ACHS*",         "*-ACHS*",       "*_ACHS*",
    "* ACHS*",     "*ACHSE",     "*ACHSEN*",     "*TAG",        "*TAGS",         "*SCHRAFF*",     "*CABINET*",
    "*WALLPAPER*", "*LEGEND*",   "*DEMO",        "*DEMOL*",     "*CENTER LINE*", "*CENTRE LINE*", "*CENTER_LINE*",
    "*ABBRUCH*",   "*WANDSCHR*", "*WANDLEUCHT*", "*WANDBELAG*", "*WANDVERKL*",   "*WANDERWEG*"};
// Inside of other words these mean something else: "ETAGE", "DEMOUNTABLE".
constexpr std::array<std::string_view, 3> kNoPartWords{"TAG", "TAGS", "DEMO"};
// AIA layer names begin with a discipline, here electrical, mechanical and plumbing, and four letters: "E-POWR-WALL".
constexpr std::string_view kOtherDisciplines = "EMP";
constexpr std::array<std::string_view, 4> kPartsOfBuildings{"WALL", "COLS", "DOOR", "GLAZ"};

/// Also a byte of a letter beyond ASCII.
bool is_letter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0 || static_cast<unsigned char>(c) > 127;
}

bool has_word(const std::string& layer, std::string_view word) {
  for (std::size_t at = layer.find(word); at != std::string::npos; at = layer.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || !is_letter(layer[at - 1])) && (end == layer.size() || !is_letter(layer[end]))) return true;
  }
  return false;
}

/// "E-POWR-WALL", also in a bound reference: "PLAN$0$E-POWR-WALL".
bool is_of_other_discipline(const std::string& layer) {
  const std::size_t bound = layer.find_last_of("$|");
  const std::string_view name = std::string_view(layer).substr(bound == std::string::npos ? 0 : bound + 1);
  if (name.size() < 6 || name[1] != '-' || kOtherDisciplines.find(name[0]) == std::string_view::npos) return false;
  const std::string_view group = name.substr(2, 4);
  if (!std::all_of(group.begin(), group.end(), is_letter) || (name.size() > 6 && name[6] != '-')) return false;
  return std::find(kPartsOfBuildings.begin(), kPartsOfBuildings.end(), group) == kPartsOfBuildings.end();
}

bool is_code(const std::string& layer) {
  return std::any_of(kCodes.begin(), kCodes.end(), [&](const char* code) { return fits_pattern(layer, code); });
}

/// Whether a layer only looks like one of walls or columns.
bool is_no_part(const std::string& layer) {
  const std::string name = upper_case_letters(layer);
  return is_of_other_discipline(name) ||
         std::any_of(kNoParts.begin(), kNoParts.end(), [&](const char* word) { return fits_pattern(name, word); }) ||
         std::any_of(kNoPartWords.begin(), kNoPartWords.end(), [&](auto word) { return has_word(name, word); }) ||
         has_word_of_no_part(layer);
}

}  // namespace

std::map<std::string, std::string> classes_of_layers() {
  std::map<std::string, std::string> classes;
  for (const char* layer : kWalls) classes[layer] = "Wall";
  for (const char* layer : kColumns) classes[layer] = "Column";
  for (const char* layer : kDoors) classes[layer] = "Door";
  for (const char* layer : kWindows) classes[layer] = "Window";
  for (const char* layer : kLeftOut) classes[layer] = "leave_out";
  return classes;
}

std::optional<std::string> LayerClasses::class_of(const std::string& layer) const {
  if (const std::optional<std::string> type = given_.class_of(layer)) return type;
  std::optional<std::string> type = built_in_.class_of(layer);
  if (!type || is_code(layer))
    if (const auto said = class_by_words(layer)) type = said;
  return type && is_no_part(layer) ? ClassRules::kLeaveOut : type;
}

}  // namespace opal::dxf_importer
