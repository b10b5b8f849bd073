#include "osm_reader.hpp"

#include <opal/common/error.hpp>

#include <fmt/format.h>

namespace opal::geojson_importer {
namespace {

using nlohmann::json;

class OverpassReader {
 public:
  explicit OverpassReader(const std::string& path) : path_(path) {}

  OsmExtract run(const json& document) {
    const json& elements = document.at("elements");
    if (!elements.is_array()) fail("/elements", "no array", "an array");
    for (std::size_t k = 0; k < elements.size(); ++k) add(elements[k], fmt::format("/elements/{}", k));
    return std::move(extract_);
  }

 private:
  [[noreturn]] void fail(const std::string& where, const std::string& found, const std::string& expected) const {
    throw MapError(path_ + ": " + where + ": " + found + ", expected " + expected);
  }

  std::int64_t id_of(const json& object, const char* key, const std::string& where) const {
    if (!object.contains(key) || !object.at(key).is_number_integer())
      fail(where, fmt::format("no {}", key), "an integer");
    return object.at(key);
  }

  static bool is_position(const json& object) {
    return object.is_object() && object.contains("lat") && object.at("lat").is_number() && object.contains("lon") &&
           object.at("lon").is_number();
  }

  static std::string text(const json& object, const char* key) {
    return object.contains(key) && object.at(key).is_string() ? object.at(key).get<std::string>() : "";
  }

  void add(const json& element, const std::string& where) {
    if (!element.is_object()) fail(where, "no object", "a node, a way or a relation");
    const std::string type = text(element, "type");
    if (type == "node") {
      if (!is_position(element)) fail(where, "a node without lat and lon", "both");
      OsmNode& node = extract_.nodes[id_of(element, "id", where)];
      node.position = {element.at("lon"), element.at("lat")};
      add_tags(element, where, node.tags);
    } else if (type == "way") {
      OsmWay& way = extract_.ways[id_of(element, "id", where)];
      add_nodes(element, where, way);
      add_tags(element, where, way.tags);
    } else if (type == "relation") {
      OsmRelation& relation = extract_.relations[id_of(element, "id", where)];
      add_members(element, where, relation);
      add_tags(element, where, relation.tags);
    }  // else: areas and counts, which have no shape
  }

  /// The same object may come twice: with tags, and without ("out skel").
  void add_tags(const json& element, const std::string& where, std::map<std::string, std::string>& tags) const {
    if (!element.contains("tags")) return;
    if (!element.at("tags").is_object()) fail(where + "/tags", "no object", "tags");
    for (const auto& [key, value] : element.at("tags").items())
      tags[key] = value.is_string() ? value.get<std::string>() : value.dump();
  }

  void add_nodes(const json& element, const std::string& where, OsmWay& way) const {
    if (element.contains("nodes") && element.at("nodes").is_array()) {
      way.nodes.clear();
      for (const json& node : element.at("nodes")) {
        if (!node.is_number_integer()) fail(where + "/nodes", node.dump().substr(0, 40), "numbers of nodes");
        way.nodes.push_back(node);
      }
    }
    add_positions(element, way);
  }

  /// As "out geom" has them; null stands for a node outside of the query's box.
  static void add_positions(const json& element, OsmWay& way) {
    if (!element.contains("geometry") || !element.at("geometry").is_array()) return;
    std::vector<OsmPosition> positions;
    for (const json& position : element.at("geometry")) {
      if (!is_position(position)) return;
      positions.emplace_back(position.at("lon"), position.at("lat"));
    }
    way.positions = std::move(positions);
  }

  void add_members(const json& element, const std::string& where, OsmRelation& relation) {
    if (!element.contains("members") || !element.at("members").is_array()) return;
    relation.members.clear();
    for (const json& member : element.at("members")) {
      if (!member.is_object()) fail(where + "/members", "no object", "members");
      const std::int64_t id = id_of(member, "ref", where + "/members");
      relation.members.push_back({text(member, "type"), text(member, "role"), id});
      if (relation.members.back().type == "way") add_positions(member, extract_.ways[id]);
    }
  }

  const std::string& path_;
  OsmExtract extract_;
};

}  // namespace

OsmExtract read_overpass(const json& document, const std::string& path) { return OverpassReader(path).run(document); }

}  // namespace opal::geojson_importer
