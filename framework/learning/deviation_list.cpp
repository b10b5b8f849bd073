#include "learning/deviation_list.hpp"

#include "common/csv_table.hpp"

#include <fmt/format.h>

#include <map>

namespace opal {
namespace {

/// "Ground floor/0pGAjlJMP3ifYPATVF5xAR" has the GlobalId "0pGAjlJMP3ifYPATVF5xAR"; a GlobalId has no slash.
std::string global_id_of(const MapObject& object) {
  if (!object.notes.source_class.starts_with("Ifc")) return "";
  return object.id.substr(object.id.rfind('/') + 1);
}

/// What the source says of an object; empty fields for something added.
std::string source_fields(const MapObject* object) {
  if (!object) return ",,,";
  return fmt::format("{},{},{},{}", csv_field(global_id_of(*object)), csv_field(object->notes.name),
                     csv_field(object->notes.storey),
                     csv_field(fmt::format("{}", fmt::join(object->notes.merged_ids, " "))));
}

}  // namespace

std::string deviation_csv(const SemanticMap& map, const Learned& learned) {
  std::map<std::string, const MapObject*> objects;
  for (const MapObject& object : map.objects()) objects.emplace(object.id, &object);
  std::string csv =
      "object,type,change,probability,moved_x_m,moved_y_m,sigma_m,visits_for,visits_against,drives,global_id,name,"
      "storey,"
      "merged_ids\n";
  for (const Proposal& p : learned.proposals) {
    const auto object = objects.find(p.id);
    csv += fmt::format("{},{},{},{:.4f},{:.3f},{:.3f},{:.3f},{},{},{},{}\n", csv_field(p.id), csv_field(p.type),
                       name_of(p.change), p.probability, p.moved.x(), p.moved.y(), p.sigma_m, p.visits_for,
                       p.visits_against, p.drives.size(),
                       source_fields(object == objects.end() ? nullptr : object->second));
  }
  return csv;
}

}  // namespace opal
