#include "part_words.hpp"

#include "feature_classes.hpp"

#include <opal/common/letter_case.hpp>

#include <string_view>
#include <vector>

namespace opal::geojson_importer {
namespace {

// Words in the names of properties that say what a thing is, or what it is used for.
constexpr std::string_view kKindKeys[] = {
    "TYPE",      "TYP",    "TIPO",    "TYPES",    "USE",     "USAGE", "NUTZUNG",  "CATEGORY",       "CATEGORIA",
    "KATEGORIE", "CLASS",  "KIND",    "FUNCTION", "SUBTYPE", "ROOM",  "ROOMTYPE", "SPACETYPE",      "AREATYPE",
    "USETYPE",   "INDOOR", "AMENITY", "HIGHWAY",  "LAYER",   "GROUP", "ELEMENT",  "CLASSIFICATION", "BUILDINGPART"};
constexpr std::string_view kWalls[] = {"WALL",  "WALLS", "INDOORWALL", "WAND", "WÄNDE",  "MUR",   "MURS",  "MURO",
                                       "MUROS", "PARED", "PAREDES",    "MURI", "PARETE", "СТЕНА", "СТЕНЫ", "墙"};
constexpr std::string_view kColumns[] = {"COLUMN", "COLUMNS", "PILLAR", "PILLARS",
                                         "STÜTZE", "STÜTZEN", "SÄULE",  "SÄULEN"};
constexpr std::string_view kDoors[] = {"DOOR", "DOORS", "DOORWAY", "TÜR", "TÜREN", "PORTE", "PUERTA", "PORTA", "ДВЕРЬ"};
constexpr std::string_view kWindows[] = {"WINDOW", "WINDOWS", "FENSTER", "FENÊTRE", "VENTANA", "FINESTRA", "ОКНО"};
// Between two of these stands no wall.
constexpr std::string_view kCorridors[] = {
    "CORRIDOR",  "CORRIDORS", "HALLWAY",   "HALLWAYS",  "LOBBY",  "FOYER",    "PASSAGE",   "PASSAGEWAY",
    "WALKWAY",   "AISLE",     "ATRIUM",    "CONCOURSE", "LOUNGE", "WAITING",  "CAFETERIA", "CANTEEN",
    "RECEPTION", "DINING",    "LIVING",    "FLUR",      "GANG",   "KORRIDOR", "COULOIR",   "CIRCULATION",
    "PASILLO",   "CORREDOR",  "CORRIDOIO", "КОРИДОР",   "走廊",   "廊下",     "복도"};
constexpr std::string_view kRooms[] = {
    "ROOM",      "ROOMS",     "OFFICE",   "OFFICES",    "CLASSROOM",  "CLASSROOMS",  "BEDROOM",   "BATHROOM",
    "RESTROOM",  "RESTROOMS", "WASHROOM", "TOILET",     "TOILETS",    "WC",          "KITCHEN",   "STORAGE",
    "STOREROOM", "SHOP",      "STORE",    "LAB",        "LABORATORY", "AUDITORIUM",  "LIBRARY",   "CLOSET",
    "STAIR",     "STAIRS",    "STAIRWAY", "STAIRWELL",  "STAIRCASE",  "STEPS",       "ELEVATOR",  "ELEVATORS",
    "LIFT",      "SHAFT",     "MEETING",  "CONFERENCE", "LECTURE",    "SEMINAR",     "WORKSHOP",  "RAUM",
    "BÜRO",      "ZIMMER",    "KÜCHE",    "TOILETTE",   "TREPPE",     "TREPPENHAUS", "AUFZUG",    "LAGER",
    "LABOR",     "HÖRSAAL",   "PIÈCE",    "PIECE",      "BUREAU",     "SALLE",       "TOILETTES", "ESCALIER",
    "ASCENSEUR", "AULA",      "OFICINA",  "BAÑO",       "ESCALERA",   "ASCENSOR",    "COCINA",    "SALA",
    "BANHEIRO",  "ESCADA",    "STANZA",   "UFFICIO",    "BAGNO",      "ASCENSORE",   "КОМНАТА",   "КАБИНЕТ",
    "АУДИТОРИЯ", "ТУАЛЕТ",    "ЛЕСТНИЦА", "ЛИФТ",       "房间",       "教室",        "办公室",    "厕所",
    "卫生间",    "楼梯",      "电梯",     "部屋",       "階段",       "강의실",      "사무실",    "화장실",
    "계단"};
// Other words for rooms also name what is in them: "offices", "toilets".
constexpr std::string_view kCalledRooms[] = {"ROOM", "ROOMS"};
// A text of more words describes something, and is no kind.
constexpr std::size_t kMostWords = 4;

using Words = std::vector<std::string>;

bool is_area(const Feature& feature) { return !feature.shapes.polygons.empty(); }

std::optional<std::string> class_of_words(const Words& words, bool may_be_area) {
  if (words.empty() || words.size() > kMostWords) return std::nullopt;
  if (has_any_word(words, kWalls)) return "opal:Wall";
  if (has_any_word(words, kColumns)) return "opal:Column";
  if (has_any_word(words, kDoors)) return "opal:Door";
  if (has_any_word(words, kWindows)) return "opal:Window";
  if (!may_be_area) return std::nullopt;
  // "lift lobby", "waiting room": a wall that is missing on the map does less harm than one that is none.
  if (has_any_word(words, kCorridors) || (words.size() == 1 && words.front() == "HALL")) return kCorridor;
  return has_any_word(words, kRooms) ? std::optional<std::string>(kRoom) : std::nullopt;
}

/// Keys of OpenStreetMap that also stand outside: they speak of rooms on a level only.
bool is_outside(const Feature& feature, const std::string& key) {
  if (key != "amenity" && key != "highway") return false;
  return !feature.properties.contains("level") && !feature.properties.contains("repeat_on") &&
         !feature.properties.contains("indoor");
}

}  // namespace

std::optional<std::pair<std::string, std::string>> class_by_words(const Feature& feature) {
  for (const auto& [key, value] : feature.properties.items()) {
    const std::string name = lower_case_letters(key);
    if (!value.is_string() || value == "no") continue;
    const std::string text = value.get<std::string>();
    const auto found = [&, &known = key](const std::string& type) { return std::pair(type, known + "=" + text); };
    if (is_area(feature) && (name == "stairs" || name == "elevator") && text == "yes") return found(kRoom);
    if (name == "name" && words_of_name(text).size() == 1)  // "wall_12" of programs that have no other property
      if (const auto type = class_of_words(words_of_name(text), false)) return found(*type);
    if (!has_any_word(words_of_name(key), kKindKeys) || is_outside(feature, name)) continue;
    if (const auto type = class_of_words(words_of_name(text), is_area(feature))) return found(*type);
    if (is_area(feature) && name == "room") return found(kRoom);  // room=* of OpenStreetMap
  }
  return std::nullopt;
}

bool is_kind_key(const std::string& key) { return has_any_word(words_of_name(key), kKindKeys); }

std::optional<std::string> class_by_name(const std::string& collection) {
  const Words words = words_of_name(collection);
  const auto type = class_of_words(words, true);
  return type && *type == kRoom && !has_any_word(words, kCalledRooms) ? std::nullopt : type;
}

}  // namespace opal::geojson_importer
