#include "cli/drive/floor_picture.hpp"

#include "common/whole_file.hpp"
#include "drawing/drawing.hpp"
#include "report/quantity_text.hpp"

namespace opal::cli {

std::string draw_floor(const simulation::Simulation& simulation, const Point& refused,
                       const std::filesystem::path& folder) {
  DrawingScene scene;
  const SemanticMap& map = simulation.building();
  scene.map = {std::shared_ptr<const void>(), &map};  // the simulation's own
  scene.title = map.name() + ": where a start or a goal can be";
  scene.floor = simulation.floor().rectangles();
  scene.coordinates = true;
  scene.unmapped = simulation.unmapped();
  scene.notes = {"The numbers are coordinates of the map [m].",
                 "Green is floor where the robot has room, and which doors that stand open connect."};
  const auto [low, high] = simulation.solids().bounds();
  if (((refused - low).array() >= 0).all() && ((high - refused).array() >= 0).all())
    scene.places = {{refused, "the place that was refused"}};
  else
    scene.notes.push_back("The place that was refused lies beyond the picture, at " + place_text(refused) + ".");
  make_folder(folder.string());
  write_svg(scene, (folder / "floor.svg").string());
  write_png(scene, (folder / "floor.png").string());
  return (folder / "floor.svg").string();
}

}  // namespace opal::cli
