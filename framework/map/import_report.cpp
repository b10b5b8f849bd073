#include <opal/map/map_importer.hpp>

#include <array>

namespace opal {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<const char*, 5> kStatusNames{"imported", "merged", "left_out", "not_cut", "unreadable"};

Json written(const ImportedElement& element) {
  Json outline = Json::array(), circles = Json::array();
  for (const Segment& s : element.outline) outline.push_back({s.begin.x(), s.begin.y(), s.end.x(), s.end.y()});
  for (const Circle& c : element.circles) circles.push_back({c.center.x(), c.center.y(), c.radius_m});
  return {{"guid", element.id},           {"class", element.source_class},
          {"name", element.name},         {"status", name_of(element.status)},
          {"reason", element.reason},     {"outline", std::move(outline)},
          {"circles", std::move(circles)}};
}

}  // namespace

const char* name_of(ImportStatus status) { return kStatusNames.at(static_cast<std::size_t>(status)); }

nlohmann::ordered_json import_report(const MapImport& imported) {
  Json elements = Json::array();
  for (const ImportedElement& element : imported.elements) elements.push_back(written(element));
  Json report = Json::object();
  report["height_m"] = imported.height_m ? Json(*imported.height_m) : Json(nullptr);
  report["sentences"] = imported.report;
  report["elements"] = std::move(elements);
  return report;
}

}  // namespace opal
