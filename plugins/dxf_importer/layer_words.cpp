#include "layer_words.hpp"

#include <opal/common/letter_case.hpp>

#include <algorithm>
#include <iterator>
#include <string_view>
#include <vector>

namespace opal::dxf_importer {
namespace {

// Whole words, in upper case: English, French, Spanish, Portuguese and Italian, German and Dutch, the languages of the
// North, Polish, Czech, Slovak, Croatian and Serbian, Romanian, Hungarian, Turkish, Greek, Russian and Ukrainian,
// Hebrew, Arabic and Persian, Vietnamese, Indonesian. TABI, PARE and ALVE are what four letters leave of Spanish and
// Portuguese ones.
constexpr std::string_view kWallWords[] = {
    "WALL",        "WALLS",       "OUTERWALL",   "INNERWALL",   "EXTWALL",    "INTWALL",    "SHEARWALL",  "DRYWALL",
    "MASONRY",     "BRICKWORK",   "PARTITION",   "PARTITIONS",  "MUR",        "MURS",       "MURO",       "MUROS",
    "MURI",        "MURATURA",    "MURATURE",    "PARETE",      "PARETI",     "PARED",      "PAREDES",    "PAREDE",
    "TRAMEZZO",    "TRAMEZZI",    "TRAMEZZE",    "TABIQUE",     "TABIQUES",   "TABIQUERIA", "TABIQUERÍA", "TABI",
    "PARE",        "ALVE",        "ALVENARIA",   "CLOISON",     "CLOISONS",   "REFEND",     "REFENDS",    "MAÇONNERIE",
    "MACONNERIE",  "WAND",        "WÄNDE",       "WAENDE",      "MAUER",      "MAUERN",     "MAUERWERK",  "TROCKENBAU",
    "TRENNWÄNDE",  "MUREN",       "MUUR",        "BINNENMUUR",  "BUITENMUUR", "METSELWERK", "VÄGG",       "VÄGGAR",
    "INNERVÄGG",   "YTTERVÄGG",   "INNERVÄGGAR", "YTTERVÄGGAR", "VEGG",       "VEGGER",     "YTTERVEGG",  "INNERVEGG",
    "YTTERVEGGER", "INNERVEGGER", "VÆG",         "VÆGGE",       "YDERVÆG",    "INDERVÆG",   "YDERVÆGGE",  "INDERVÆGGE",
    "SEINÄ",       "SEINÄT",      "ULKOSEINÄ",   "ULKOSEINÄT",  "VÄLISEINÄ",  "VÄLISEINÄT", "ŚCIANA",     "ŚCIANY",
    "SCIANA",      "SCIANY",      "MURY",        "STĚNA",       "STĚNY",      "STENY",      "STENA",      "STENE",
    "ZDIVO",       "ZDI",         "ZEĎ",         "PŘÍČKA",      "PŘÍČKY",     "PRICKY",     "ZID",        "ZIDOVI",
    "ZIDURI",      "PERETE",      "PEREȚI",      "PERETI",      "FALAK",      "DUVAR",      "DUVARLAR",   "ΤΟΙΧΟΣ",
    "ΤΟΙΧΟΙ",      "ΤΟΙΧΟΠΟΙΙΑ",  "СТЕНА",       "СТЕНЫ",       "СТЕН",       "СТЕНИ",      "СТІНИ",      "ПЕРЕГОРОДКА",
    "ПЕРЕГОРОДКИ", "קיר",         "קירות",       "جدار",        "جدران",      "حائط",       "دیوار",      "TƯỜNG",
    "TUONG",       "DINDING",     "TEMBOK"};
constexpr std::string_view kColumnWords[] = {
    "COLS",     "PILLAR",  "PILLARS", "POTEAU",   "POTEAUX", "PILAR",   "PILARES", "PILASTRO", "PILASTRI", "COLONNA",
    "COLONNE",  "STÜTZE",  "STÜTZEN", "STUETZEN", "SÄULE",   "SÄULEN",  "SAEULEN", "PFEILER",  "PELARE",   "SØYLER",
    "SŁUP",     "SŁUPY",   "SLUPY",   "SLOUPY",   "STUPOVI", "STUBOVI", "STÂLPI",  "STALPI",   "OSZLOP",   "KOLON",
    "KOLONLAR", "КОЛОННА", "КОЛОННЫ", "КОЛОНИ",   "עמוד",    "עמודים",  "عمود",    "ستون",     "CỘT"};
constexpr std::string_view kDoorWords[] = {
    "DOOR",  "DOORS",  "PORTE", "PORTES", "PORTA", "PORTAS", "PUERTA", "PUERTAS", "TÜR",   "TÜREN", "TUEREN",  "DEUREN",
    "DÖRR",  "DÖRRAR", "DØRER", "OVET",   "DRZWI", "DVEŘE",  "VRATA",  "UȘI",     "AJTÓK", "KAPI",  "KAPILAR", "ΠΟΡΤΕΣ",
    "ДВЕРЬ", "ДВЕРИ",  "ДВЕРІ", "문",     "דלת",   "דלתות",  "باب",    "درب",     "CỬA",   "PINTU"};
constexpr std::string_view kWindowWords[] = {
    "WINDOW",   "WINDOWS",    "CURTAIN",  "GLASS",   "GLAZING",  "FENÊTRE",    "FENÊTRES", "FENETRE",
    "FENETRES", "VITRAGE",    "VITRAGES", "VENTANA", "VENTANAS", "JANELA",     "JANELAS",  "FINESTRA",
    "FINESTRE", "SERRAMENTI", "INFISSI",  "FENSTER", "FÖNSTER",  "VINDUER",    "IKKUNAT",  "OKNO",
    "OKNA",     "PROZORI",    "FERESTRE", "ABLAKOK", "PENCERE",  "PENCERELER", "ΠΑΡΑΘΥΡΑ", "ОКНО",
    "ОКНА",     "ВІКНА",      "창",       "חלון",    "חלונות",   "نافذة",      "پنجره",    "JENDELA"};
// Chinese, Japanese and Korean words stand beside each other without a gap.
constexpr std::string_view kWallSigns[] = {"墙", "牆", "壁", "間仕切", "벽"};
constexpr std::string_view kColumnSigns[] = {"柱", "기둥"};
constexpr std::string_view kDoorSigns[] = {"门", "門", "扉", "建具"};
constexpr std::string_view kWindowSigns[] = {"窗", "窓", "幕墙", "幕牆", "玻璃", "창호", "유리", "ガラス"};

constexpr std::string_view kWordsOfNoPart[] = {
    "CENTERLINE", "CENTRELINE", "CENTERLINES", "CENTRELINES", "CNTR",     "OVERHEAD", "TEXT",     "TEXTS",
    "TXT",        "TEXTE",      "TEXTES",      "TEXTO",       "TEXTOS",   "TESTI",    "DIM",      "DIMS",
    "QUOTE",      "QUOTA",      "COTA",        "COTAS",       "COTE",     "COTES",    "COTATION", "BEMASSUNG",
    "BEMAẞUNG",   "PROSPETTO",  "PROSPETTI",   "SEZIONE",     "SEZIONI",  "ARREDO",   "ARREDI",   "ATTREZZATA",
    "MOBILIER",   "MUEBLES",    "MOBILIARIO",  "MÖBEL",       "MOEBEL",   "EJE",      "EJES",     "EIXO",
    "EIXOS",      "ASSE",       "ASSI",        "OSIE",        "OSY",      "ОСЬ",      "ОСИ",      "ОСІ",
    "РАЗМЕРЫ",    "ТЕКСТ",      "МЕБЕЛЬ",      "МЕБЛІ",       "ДЕМОНТАЖ", "VIRTUAL",  "SOCKET",   "SOCKETS"};
// Centre lines, axes, dimensions, texts, furniture, wallpaper, tiles, what is to be demolished.
constexpr std::string_view kSignsOfNoPart[] = {"芯",   "中心", "壁心", "柱心", "轴",   "軸",   "尺寸", "寸法",
                                               "标注", "文字", "家具", "壁纸", "壁紙", "墙纸", "墙砖", "벽지",
                                               "壁柜", "拆",   "중심", "치수", "문자", "가구", "철거"};

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
