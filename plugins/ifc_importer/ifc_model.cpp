// The one translation unit that knows IfcPlusPlus: its headers take long to compile.
#include "ifc_model.hpp"

#include "ifcpp/elements.hpp"
#include "ifcpp/units.hpp"
#include "side_types.hpp"

#include <opal/common/error.hpp>
#include <opal/import_kit/far_origin.hpp>

#include <ifcpp/IFC4/include/IfcBuildingStorey.h>
#include <ifcpp/IFC4/include/IfcGeometricRepresentationContext.h>
#include <ifcpp/IFC4/include/IfcMapConversion.h>
#include <ifcpp/IFC4/include/IfcProjectedCRS.h>
#include <ifcpp/model/BuildingException.h>
#include <ifcpp/model/BuildingModel.h>
#include <ifcpp/reader/ReaderSTEP.h>

#include <fmt/format.h>

#include <map>
#include <set>

namespace opal::ifc_importer {
namespace {

using namespace ifcpp;

/// What the library says while it reads; it would be lost otherwise.
struct Messages {
  std::map<std::string, int> counts;

  // NOLINTNEXTLINE(performance-unnecessary-value-param): the library's type of a callback
  static void take(void* self, shared_ptr<StatusCallback::Message> message) {
    const auto type = message ? message->m_message_type : StatusCallback::MESSAGE_TYPE_UNKNOWN;
    if (type != StatusCallback::MESSAGE_TYPE_ERROR && type != StatusCallback::MESSAGE_TYPE_WARNING) return;
    auto& counts = static_cast<Messages*>(self)->counts;
    if (counts.size() < 1000) ++counts[utf8(message->m_message_text)];
  }
};

class Reading {
 public:
  Reading(const StepText& step, const std::string& name, const Point& origin_m)
      : step_(step), name_(name), origin_m_(origin_m) {}

  Building building() {
    load();
    expect_whole();
    const LengthUnit unit = unit_of_length();
    Building building;
    building.schema = step_.schema();
    building.notes = step_.left_out();
    building.unit_m = unit.metres;
    building.unit_name = unit.name;
    Bodies bodies(model_->getUnitConverter(), unit.metres, indexed_curves());
    Elements elements(bodies, unit.metres, origin_m_);
    std::map<std::string, int> shapeless;
    for (const auto& [number, entity] : model_->getMapIfcEntities()) {
      if (const auto storey = as<IfcBuildingStorey>(entity)) read_level(*storey, elements, unit.metres, building);
      const auto product = as<IfcProduct>(entity);
      if (!product || is<IfcFeatureElement>(*product)) continue;
      if (const auto element = as<IfcElement>(entity))
        building.elements.push_back(elements.read(*element));
      else if (product->m_Representation)
        ++shapeless[product->className()];
    }
    for (const auto& [class_name, count] : shapeless)
      building.notes.push_back(fmt::format("left out: {} {}, which are no things of the building", count, class_name));
    building.first_far_m = bodies.first_far_m();
    read_context(building, unit.metres);
    finish(building);
    return building;
  }

 private:
  void load() {
    std::string text = step_.for_parser();
    model_ = std::make_shared<BuildingModel>();
    model_->setMessageCallBack(&messages_, &Messages::take);
    ReaderSTEP reader;
    reader.setMessageCallBack(&messages_, &Messages::take);
    try {
      reader.loadModelFromString(text, model_);
    } catch (const std::exception& error) {
      throw MapError(name_ + ": " + error.what() + ", expected an IFC model");
    }
    model_->setMessageCallBack(&messages_, &Messages::take);
  }

  /// The library leaves out what it cannot read, and says nothing.
  void expect_whole() {
    const auto& loaded = model_->getMapIfcEntities();
    std::set<std::string> known;
    for (const auto& [number, entity] : loaded) known.insert(upper(entity->className()));
    for (const StepInstance& instance : step_.instances()) {
      if (loaded.count(instance.number)) continue;
      const std::string type(instance.type);
      if (known.count(type) && !is_side_information(type))
        throw MapError(
            fmt::format("{}: #{} ({}) cannot be read, expected a whole model", name_, instance.number, type));
      (known.count(type) ? unread_ : unknown_)[type].push_back(std::string(instance.global_id));
    }
  }

  IndexedCurves indexed_curves() const {
    IndexedCurves curves;
    for (const StepInstance& instance : step_.instances())
      if (instance.type == "IFCINDEXEDPOLYCURVE")
        if (const auto arguments = split_arguments(instance.arguments);
            arguments.size() > 1 && arguments[1].find('(') != std::string::npos)
          curves.emplace(instance.number, indexed_segments(arguments[1]));
    return curves;
  }

  static std::string upper(std::string text) {
    for (char& c : text)
      if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    return text;
  }

  LengthUnit unit_of_length() {
    try {
      const LengthUnit unit = length_unit(model_->getIfcProject());
      model_->getUnitConverter()->setLengthInMeterFactor(unit.metres);
      return unit;
    } catch (const Unreadable& trouble) {
      throw MapError(name_ + ": the project " + trouble.what() + ", expected a unit of length" +
                     (step_.is_cut_off() ? "; the file is cut off, and may have had one" : ""));
    }
  }

  static void read_level(const IfcBuildingStorey& storey, const Elements& elements, double unit_m, Building& building) {
    Level level{text_of(storey.m_GlobalId), text_of(storey.m_Name), 0};
    const std::optional<double> height_m = elements.height_of(storey);
    if (height_m)
      level.elevation_m = *height_m;
    else if (storey.m_Elevation && std::isfinite(storey.m_Elevation->m_value))
      level.elevation_m = unit_m * storey.m_Elevation->m_value;
    building.levels.push_back(std::move(level));
  }

  void read_context(Building& building, double unit_m) const {
    for (const auto& [number, entity] : model_->getMapIfcEntities()) {
      const auto context = as<IfcGeometricRepresentationContext>(entity);
      if (context && context->m_TrueNorth && !building.north_rad) read_north(*context, building);
      const auto conversion = as<IfcMapConversion>(entity);
      if (conversion && !building.georeference) read_georeference(*conversion, unit_m, building);
    }
  }

  static void read_north(const IfcGeometricRepresentationContext& context, Building& building) {
    try {
      const Point3 north = direction_of(context.m_TrueNorth, Point3::UnitY());
      building.north_rad = std::atan2(north.y(), north.x());
    } catch (const Unreadable& trouble) {
      building.notes.push_back(std::string("true north ") + trouble.what() + ": not kept");
    }
  }

  void read_georeference(const IfcMapConversion& conversion, double unit_m, Building& building) const {
    try {
      take_georeference(conversion, unit_m, building);
    } catch (const Unreadable& trouble) {
      building.notes.push_back(std::string("its map conversion ") + trouble.what() + ": not taken as a georeference");
    }
  }

  /// A conversion by nothing is an exporter's default, and latitude and longitude of the site often are.
  void take_georeference(const IfcMapConversion& conversion, double unit_m, Building& building) const {
    const auto crs = as<IfcProjectedCRS>(conversion.m_TargetCRS);
    const double map_unit_m = crs && crs->m_MapUnit ? length_unit(crs->m_MapUnit).metres : unit_m;
    const auto metres = [map_unit_m](const auto& length) { return length ? map_unit_m * length->m_value : 0.0; };
    Georeference place;
    if (crs) place.crs = text_of(crs->m_Name);
    place.eastings_m = metres(conversion.m_Eastings);
    place.northings_m = metres(conversion.m_Northings);
    place.height_m = metres(conversion.m_OrthogonalHeight);
    if (conversion.m_XAxisAbscissa && conversion.m_XAxisOrdinate)
      place.heading_rad = std::atan2(conversion.m_XAxisOrdinate->m_value, conversion.m_XAxisAbscissa->m_value);
    const Point origin_m = Pose2(0, 0, place.heading_rad) * origin_m_;
    place.eastings_m += origin_m.x();
    place.northings_m += origin_m.y();
    const bool is_real = !place.crs.empty() && std::hypot(place.eastings_m, place.northings_m) > 1 &&
                         std::isfinite(place.eastings_m + place.northings_m + place.height_m + place.heading_rad);
    if (is_real)
      building.georeference = place;
    else
      building.notes.push_back(
          "its map conversion names no coordinate system or moves nothing: not taken as a georeference");
  }

  /// Every thing has an id of its own, and all stand in order of id.
  void finish(Building& building) {
    std::ranges::sort(building.levels, [](const Level& a, const Level& b) {
      return std::tie(a.elevation_m, a.id) < std::tie(b.elevation_m, b.id);
    });
    std::ranges::stable_sort(building.elements, {}, &Element::id);
    std::set<std::string> ids;
    for (Element& element : building.elements) {
      const std::string id = element.id.empty() ? "without-GlobalId" : element.id;
      std::string own = id;
      for (int k = 2; !ids.insert(own).second; ++k) own = id + "-" + std::to_string(k);
      if (own != element.id)
        building.notes.push_back("the GlobalId '" + element.id + "' is not the only one: a thing is called " + own);
      element.id = own;
    }
    for (const auto& [type, global_ids] : unknown_) {
      std::string note = fmt::format("left out: {} {}, a class that is not known", global_ids.size(), type);
      for (const std::string& id : global_ids)
        if (!id.empty()) note += " " + id;
      building.notes.push_back(note);
    }
    for (const auto& [type, global_ids] : unread_)
      building.notes.push_back(
          fmt::format("left out: {} {} that cannot be read, and is no part of the building", global_ids.size(), type));
    for (const auto& [message, count] : messages_.counts)
      building.notes.push_back("while reading: " + message + (count > 1 ? fmt::format(" ({} times)", count) : ""));
  }

  const StepText& step_;
  const std::string& name_;
  const Point origin_m_;
  Messages messages_;
  shared_ptr<BuildingModel> model_;
  std::map<std::string, std::vector<std::string>> unknown_, unread_;  // GlobalIds by type
};

bool has_bodies(const Building& building) {
  return std::ranges::any_of(building.elements, [](const Element& element) { return !element.bodies.empty(); });
}

}  // namespace

Building read_building(const StepText& step, const std::string& name, const Point& origin_m) {
  try {
    Building building = Reading(step, name, origin_m).building();
    const Point far_m = building.first_far_m && origin_m.isZero() && !has_bodies(building)
                            ? origin_of_far_plan(*building.first_far_m, *building.first_far_m)
                            : Point::Zero();
    if (far_m.isZero()) return building;
    building = Reading(step, name, far_m).building();
    building.notes.push_back(sentence_about_far_origin(far_m));
    return building;
  } catch (const MapError&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw MapError(name + ": takes more memory than there is");
  } catch (const std::exception& error) {
    throw MapError(name + ": " + error.what() + ", expected an IFC model");
  }
}

}  // namespace opal::ifc_importer
