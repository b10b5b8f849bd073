#include "layer_words.hpp"

#include <opal/common/letter_case.hpp>

#include <algorithm>
#include <iterator>
#include <string_view>
#include <vector>

namespace opal::dxf_importer {
namespace {

// Whole words, in upper case: French, Spanish, Portuguese and Italian, German and Dutch, the languages of the North,
// Polish, Czech, Hungarian, Turkish, Russian and Ukrainian, Hebrew.
constexpr std::string_view kWallWords[] = {
    "MUR",       "MURS",    "MURO",   "MUROS",    "MURI",     "MURATURA",    "MURATURE",    "PARETE",     "PARETI",
    "PARED",     "PAREDES", "PAREDE", "TRAMEZZO", "TRAMEZZI", "TABIQUE",     "TABIQUES",    "CLOISON",    "CLOISONS",
    "ALVENARIA", "WAND",    "WÄNDE",  "WAENDE",   "MAUER",    "MAUERN",      "MAUERWERK",   "TRENNWÄNDE", "MUREN",
    "MUUR",      "VÄGG",    "VÄGGAR", "VEGG",     "VEGGER",   "VÆG",         "VÆGGE",       "SEINÄ",      "SEINÄT",
    "ŚCIANA",    "ŚCIANY",  "SCIANY", "STĚNA",    "STĚNY",    "STENY",       "ZDIVO",       "FALAK",      "DUVAR",
    "DUVARLAR",  "СТЕНА",   "СТЕНЫ",  "СТЕН",     "СТІНИ",    "ПЕРЕГОРОДКА", "ПЕРЕГОРОДКИ", "קיר",        "קירות"};
constexpr std::string_view kColumnWords[] = {
    "POTEAU",  "POTEAUX",  "PILAR",   "PILARES", "PILASTRO", "PILASTRI", "COLONNA", "COLONNE", "STÜTZE",
    "STÜTZEN", "STUETZEN", "PELARE",  "SØYLER",  "SŁUP",     "SŁUPY",    "SLUPY",   "SLOUPY",  "OSZLOP",
    "KOLON",   "KOLONLAR", "КОЛОННА", "КОЛОННЫ", "КОЛОНИ",   "עמוד",     "עמודים"};
constexpr std::string_view kDoorWords[] = {"PORTE", "PORTES", "PORTA",  "PORTAS", "PUERTA",  "PUERTAS", "TÜR",
                                           "TÜREN", "TUEREN", "DEUREN", "DÖRR",   "DÖRRAR",  "DØRER",   "OVET",
                                           "DRZWI", "DVEŘE",  "AJTÓK",  "KAPI",   "KAPILAR", "ДВЕРЬ",   "ДВЕРИ",
                                           "ДВЕРІ", "문",     "דלת",    "דלתות"};
constexpr std::string_view kWindowWords[] = {
    "FENÊTRE",  "FENÊTRES", "FENETRE",    "FENETRES", "VITRAGE", "VITRAGES", "VENTANA", "VENTANAS", "JANELA", "JANELAS",
    "FINESTRA", "FINESTRE", "SERRAMENTI", "INFISSI",  "FENSTER", "FÖNSTER",  "VINDUER", "IKKUNAT",  "OKNO",   "OKNA",
    "ABLAKOK",  "PENCERE",  "PENCERELER", "ОКНО",     "ОКНА",    "ВІКНА",    "창",      "חלון",     "חלונות"};
// Chinese, Japanese and Korean words stand beside each other without a gap.
constexpr std::string_view kWallSigns[] = {"墙", "牆", "壁", "間仕切", "벽"};
constexpr std::string_view kColumnSigns[] = {"柱", "기둥"};
constexpr std::string_view kDoorSigns[] = {"门", "門", "扉", "建具"};
constexpr std::string_view kWindowSigns[] = {"窗", "窓", "幕墙", "幕牆", "玻璃", "창호", "유리", "ガラス"};

constexpr std::string_view kWordsOfNoPart[] = {
    "TEXT",     "TEXTS",      "TXT",      "TEXTE",     "TEXTES",     "TEXTO",   "TEXTOS",  "TESTI",
    "DIM",      "DIMS",       "QUOTE",    "QUOTA",     "COTA",       "COTAS",   "COTE",    "COTES",
    "COTATION", "BEMASSUNG",  "BEMAẞUNG", "PROSPETTO", "PROSPETTI",  "SEZIONE", "SEZIONI", "ARREDO",
    "ARREDI",   "ATTREZZATA", "MOBILIER", "MUEBLES",   "MOBILIARIO", "MÖBEL",   "MOEBEL",  "EJE",
    "EJES",     "EIXO",       "EIXOS",    "ASSE",      "ASSI",       "OSIE",    "OSY",     "ОСЬ",
    "ОСИ",      "ОСІ",        "РАЗМЕРЫ",  "ТЕКСТ",     "МЕБЕЛЬ",     "МЕБЛІ",   "ДЕМОНТАЖ"};
// Centre lines, axes, dimensions, texts, furniture, wallpaper, tiles, what is to be demolished.
constexpr std::string_view kSignsOfNoPart[] = {"芯",   "中心", "壁心", "柱心", "轴",   "軸",   "尺寸", "寸法",
                                               "标注", "文字", "家具", "壁纸", "壁紙", "墙纸", "墙砖", "벽지",
                                               "壁柜", "拆",   "중심", "치수", "문자", "가구", "철거"};

template <std::size_t N>
bool has_any_word(const std::vector<std::string>& words, const std::string_view (&known)[N]) {
  return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
    return std::find(std::begin(known), std::end(known), word) != std::end(known);
  });
}

template <std::size_t N>
bool has_any_sign(const std::string& layer, const std::string_view (&signs)[N]) {
  return std::any_of(std::begin(signs), std::end(signs),
                     [&](std::string_view sign) { return layer.find(sign) != std::string::npos; });
}

}  // namespace

std::optional<std::string> class_by_words(const std::string& layer) {
  const std::vector<std::string> words = words_of_name(layer);
  // "curtain wall, doors, windows": what the robot sees through goes before what it sees.
  if (has_any_word(words, kWindowWords) || has_any_sign(layer, kWindowSigns)) return "opal:Window";
  if (has_any_word(words, kDoorWords) || has_any_sign(layer, kDoorSigns)) return "opal:Door";
  if (has_any_word(words, kColumnWords) || has_any_sign(layer, kColumnSigns)) return "opal:Column";
  if (has_any_word(words, kWallWords) || has_any_sign(layer, kWallSigns)) return "opal:Wall";
  return std::nullopt;
}

bool has_word_of_no_part(const std::string& layer) {
  return has_any_word(words_of_name(layer), kWordsOfNoPart) || has_any_sign(layer, kSignsOfNoPart);
}

}  // namespace opal::dxf_importer
