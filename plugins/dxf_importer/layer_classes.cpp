#include "layer_classes.hpp"

#include <array>

namespace opal::dxf_importer {
namespace {

// By the US National CAD Standard (AIA; "PLAN$0$A-WALL" in a bound reference), ISO 13567 with SfB elements, and plain
// words.
constexpr std::array kWalls{"*-WALL*", "WALL*", "*_WALL*", "*WALLS",    "*MUREN*",   "*WAND", "*WAENDE*",
                            "A-21*",   "A-22*", "*MAUER*", "*WÄNDE*",   "*Wände*",   "MURS*", "MURO*",
                            "MURI*",   "MUR",   "PARED*",  "*CLOISON*", "PARTITION*"};
constexpr std::array kColumns{"*-COLS*",  "*COLUMN*", "*KOLOM*", "*STUETZE*", "*STÜTZE*",
                              "*Stütze*", "*POTEAU*", "PILLAR*", "A-28*"};
constexpr std::array kDoors{"*-DOOR*", "*DOORS",  "DOOR*",   "*DEUREN*", "*TUEREN*",
                            "*TÜREN*", "*Türen*", "PORTES*", "PUERTAS*", "A-32*"};
constexpr std::array kWindows{"*-GLAZ*",  "*WINDOW*",  "GLAZ*",     "*FENSTER*",
                              "*KOZIJN*", "*FENETRE*", "VENTANAS*", "A-31*"};
// What is written beside walls, lies above the cut or below the floor.
constexpr std::array kLeftOut{"*STEM-WALL*",  "*-WALL-HEAD*", "*-WALL-CNTR*", "*-WALL-IDEN*", "*-WALL-ABOV*",
                              "*-COLS-GRID*", "*-COLS-IDEN*", "*-DOOR-IDEN*", "*-GLAZ-IDEN*"};

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

}  // namespace opal::dxf_importer
