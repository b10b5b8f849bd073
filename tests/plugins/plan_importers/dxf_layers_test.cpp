// What the names of layers say.
#include "dxf_text.hpp"
#include "import_source.hpp"

#include <opal/common/error.hpp>

#include <catch2/catch.hpp>

using namespace opal;
using Catch::Contains;
using nlohmann::json;

namespace {

/// A drawing with a wall, and with something on one more layer.
MapImport layered_dxf(const std::string& layer, const json& options = json::object()) {
  DxfText dxf(6);
  dxf.box("A-WALL", 0, 0, 5, 0.2).box(layer, 0, 3, 5, 3.2);
  return import_text("dxf_importer", "opal:DxfImporter", "plan.dxf", dxf.text(), options);
}

}  // namespace

TEST_CASE("symbols, axes, cupboards and other disciplines are no walls and columns") {
  for (const char* layer :
       {"E-POWR-WALL", "PLAN$0$E-POWR-WALL", "M-EXHS-WALL", "P-FIXT-COLS", "COLUMN GRID", "COLUMN TAG", "COLUMN_TAGS",
        "AXE POTEAUX", "Axe_Stützen", "STÜTZENRASTER", "STÜTZENACHSE", "COLUMN AXIS", "Mauerwerk_Schraffur",
        "WALL CABINETS", "WALLPAPER LEGEND", "DEMO-WALL", "A-WALL-DEMO", "A-WALL-DEMOLITION", "Wandschrank"}) {
    CAPTURE(layer);
    const MapImport plan = layered_dxf(layer);
    CHECK(thing(plan, "101").reason == "a rule for its layer says so");
    CHECK(all<Segment>(*plan.map).size() == 4);
  }
}

TEST_CASE("words beside a code of an element say more than the code") {
  CHECK(says(layered_dxf("A-320G - Permanent Solid Partitions 1"), "Partitions 1 as opal:Wall"));
  CHECK(says(layered_dxf("A-325G - Internal Doors 2"), "Internal Doors 2 as opal:Door"));
  CHECK(says(layered_dxf("A-210G - External"), "layer A-210G - External as opal:Wall"));
  CHECK(says(layered_dxf("A-32---E-D-N"), "layer A-32---E-D-N as opal:Door"));
  CHECK(says(layered_dxf("I-321G - Virtual Partition 5"), "a rule for its layer says so: layer I-321G"));
  CHECK(says(layered_dxf("Wall sockets"), "a rule for its layer says so: layer Wall sockets"));
}

TEST_CASE("where all is on layer 0, names of blocks say what is no wall") {
  DxfText dxf(6);
  dxf.begin_block("Door 90").line("0", {0, 0}, {0, 0.9}).arc("0", {0, 0}, 0.9, 0, 90).end_block();
  dxf.begin_block("CHAIR01").box("0", 0, 0, 0.5, 0.5).end_block();
  dxf.box("0", 0, 0, 5, 0.2).insert("0", "Door 90", {6, 0}).insert("0", "CHAIR01", {3, 3});
  const auto imported = [&](const json& classes) {
    return import_text("dxf_importer", "opal:DxfImporter", "plan.dxf", dxf.text(), {{"classes", classes}});
  };
  const MapImport all_on_0 = imported({{"0", "Wall"}});
  CHECK(says(all_on_0, "layer Door 90 as opal:Door: 1 ARC, 1 LINE"));
  CHECK(says(all_on_0, "doubtful: blocks on layer 0 whose lines became walls with it"));
  CHECK(says(all_on_0, ": 1 (CHAIR01)"));
  const MapImport without = imported({{"0", "Wall"}, {"CHAIR*", "leave_out"}});
  CHECK(all<Segment>(*without.map).size() == 4);
  CHECK_FALSE(says(without, "doubtful: no layer is called"));
  CHECK_FALSE(says(without, "doubtful: blocks on layer 0"));
}

TEST_CASE("words of walls stand anywhere in the names of layers, and other words may hold the letters of symbols") {
  for (const char* layer : {"Wand (neu)", "Wand_EG", "EG_WAND_NEU", "EG-Wand-tragend", "A.Wall_Internal",
                            "WALL_ETAGE_2", "DEMOUNTABLE WALLS", "E-WALL", "WAND DACHSEITE"}) {
    CAPTURE(layer);
    CHECK(says(layered_dxf(layer), std::string("layer ") + layer + " as opal:Wall"));
  }
}

TEST_CASE("words for walls, columns, doors and windows are known in many languages, in any case and alphabet") {
  const auto becomes = [](const std::vector<std::string>& layers, const std::string& type) {
    for (const std::string& layer : layers) {
      CAPTURE(layer);
      CHECK(says(layered_dxf(layer), "layer " + layer + " as opal:" + type));
    }
  };
  becomes(
      {"0_MURATURE", "PARETI_INT", "Muri_Portanti", "A-MURO", "ALVENARIA", "code_mur", "MuroNuevo", "Tragende Wände",
       "ściany nośne", "VÄGG", "DUVAR", "Стены", "внутренние стены", "קירות", "A原建筑墙体", "外壁", "벽체"},
      "Wall");
  becomes({"PILASTRI", "Pilares", "stützen", "SŁUPY", "Колонны", "框架柱", "기둥"}, "Column");
  becomes({"1 Porte", "puerta", "türen", "Двери", "建具", "문"}, "Door");
  becomes({"2 Finestre", "JANELAS", "code_fenêtre", "Окна", "A原建筑外幕墙，门，窗", "창호"}, "Window");
}

TEST_CASE("dimensions, axes, elevations and furniture are no walls in other languages either") {
  for (const char* layer : {"A-WALL-DIMS", "WALL_TEXT", "EIXO PAREDE", "12 Prospetto Parete Attrezzata",
                            "Sezione A-A Muri", "壁芯", "墙体尺寸", "벽 중심선", "Оси стен"}) {
    CAPTURE(layer);
    CHECK(thing(layered_dxf(layer), "101").reason == "a rule for its layer says so");
  }
}

TEST_CASE("words that only hold the letters of a wall are none") {
  for (const char* layer : {"MURALS", "FEMUR", "SUPPORTE", "PORTANTI", "ECOLONNE2D", "核心筒", "문서"}) {
    CAPTURE(layer);
    CHECK(thing(layered_dxf(layer), "101").reason == "no class for its layer");
  }
}

TEST_CASE("a rule of the deployment is the same in upper and lower case of any alphabet") {
  const MapImport plan = layered_dxf("Стяжка Ö", {{"classes", {{"СТЯЖКА ö", "Wall"}}}});
  CHECK(says(plan, "layer Стяжка Ö as opal:Wall"));
}

TEST_CASE("a rule of the deployment goes before those that leave out") {
  const MapImport plan = layered_dxf("COLUMN GRID", {{"classes", {{"COLUMN*", "Column"}}}});
  CHECK(says(plan, "layer COLUMN GRID as opal:Column"));
}

TEST_CASE("where no sensor perceives anything the layers are named, and no unit is blamed") {
  DxfText dxf(4);
  dxf.line("Fenster", {0, 0}, {800, 0}).box("Mauern der Stadt", 0, 3, 5, 3.2).box("Waende", 0, 0, 9000, 200);
  const auto with = [&](const json& options) {
    return import_text("dxf_importer", "opal:DxfImporter", "plan.dxf", dxf.text(), options);
  };
  CHECK_NOTHROW(with(json::object()));
  CHECK_THROWS_WITH(with({{"classes", {{"WAENDE", "leave_out"}, {"MAUER*", "leave_out"}}}}),
                    Contains("no layer gives anything that a sensor perceives, expected the option classes to name one "
                             "of (--set \"classes.LAYER=Wall\"): 'Fenster' (1 LINE)") &&
                        Contains("'Waende' (1 LWPOLYLINE)"));
}

TEST_CASE("a drawing without a unit of which no layer gives anything is refused for its layers") {
  DxfText dxf(-1);
  dxf.line("0", {0, 0}, {5, 0});
  const auto refused = [&] { import_text("dxf_importer", "opal:DxfImporter", "plan.dxf", dxf.text()); };
  CHECK_THROWS_WITH(refused(), Contains("no layer gives anything for a map") && Contains("'0' (1 LINE)"));
  dxf.line("WALLS", {0, 3}, {5, 3});
  CHECK_THROWS_WITH(refused(), Contains("expected the option unit"));
}
