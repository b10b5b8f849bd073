#pragma once

#include <opal/map/semantic_map.hpp>

#include <nlohmann/json.hpp>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace opal {

/// What became of one thing of a source.
enum class ImportStatus {
  imported,    ///< it is in the map
  merged,      ///< another thing at the same place stands for it; `reason` says which
  left_out,    ///< it is there, but options or its kind keep it out of the map
  not_cut,     ///< it does not reach the height of the cut
  unreadable,  ///< its geometry could not be made out
};

/// "imported", "left_out": the status as a report writes it.
OPAL_EXPORT const char* name_of(ImportStatus status);

/// One thing of the source that an importer looked at, whether or not it came into the map. Frame `map`, metres.
struct ImportedElement {
  std::string id;                                ///< as the source has it: IFC GlobalId, DXF handle
  std::string source_class;                      ///< as the source has it: "IfcColumn", the layer of a drawing
  std::string name = {};                         ///< for people; may be empty
  ImportStatus status = ImportStatus::imported;  ///< what became of it
  std::string reason = {};                       ///< a sentence; empty if there is nothing to explain
  std::vector<Segment> outline = {};  ///< its own cut, before it is joined with others; no side is the visible one
  std::vector<Circle> circles = {};   ///< where the cut is round exactly; `outline` does not repeat it
};

/// What an importer made of a source, and what it left out.
struct MapImport {
  std::shared_ptr<const SemanticMap> map;  ///< never null
  /// Sentences for the person who runs the import, in reading order ("1204 wall faces, 1830 m", "left out: ...").
  std::vector<std::string> report;
  /// Every thing that the importer looked at, in order of id; empty if the source has no things (a grid).
  std::vector<ImportedElement> elements = {};
  /// Where a building was cut, in its own coordinates [m]; none if the source is flat.
  std::optional<double> height_m = {};
};

/// The report as JSON: {"height_m", "sentences", "elements": [{"guid", "class", "name", "status", "reason", "outline":
/// [[x1, y1, x2, y2], ...], "circles": [[x, y, r], ...]}, ...]}.
OPAL_EXPORT nlohmann::ordered_json import_report(const MapImport& imported);

/// A level of a building, as its source names it.
struct Storey {
  std::string id;                         ///< as the source has it
  std::string name;                       ///< for people; option `storey` takes it
  double elevation_m = 0;                 ///< of its floor, in the building's coordinates
  double height_m = 0;                    ///< where an import of this storey cuts
  std::map<std::string, int> gives = {};  ///< how many things of each class the cut meets
};

/// Makes a semantic map of one kind of source (a grid, a building model). What it does is chosen by options that its
/// plugin.jsonld describes. Options that several importers have go by the same names: `storey` (a name) or `z_m`
/// (height of the cut) choose the level; `classes` (an object) says what becomes of the source's classes or layers:
/// {"IfcFurniture": "opal:Furniture", "IfcStair": "leave_out"}.
class OPAL_EXPORT MapImporter {
 public:
  virtual ~MapImporter();
  /// True if the file looks like this importer's kind (by name and first bytes); must not throw.
  virtual bool recognizes(const std::string& path) const = 0;
  /// @throws MapError naming the file and the place in it.
  virtual MapImport import(const std::string& path) const = 0;
  /// The levels of the building, from the lowest; none for sources that have no levels, which is the default.
  /// @throws MapError naming the file and the place in it.
  virtual std::vector<Storey> storeys(const std::string& path) const;
};

}  // namespace opal
