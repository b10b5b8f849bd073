#include "osm_reader.hpp"

#include <opal/common/error.hpp>
#include <opal/common/number_text.hpp>
#include <opal/common/strict_json.hpp>

#include <expat.h>
#include <fmt/format.h>

#include <array>
#include <cstring>
#include <fstream>
#include <memory>
#include <optional>
#include <string_view>

namespace opal::geojson_importer {
namespace {

class XmlReader {
 public:
  explicit XmlReader(const std::string& path) : path_(path), parser_(XML_ParserCreate(nullptr), &XML_ParserFree) {
    XML_SetUserData(parser_.get(), this);
    XML_SetElementHandler(parser_.get(), &XmlReader::begin_element, &XmlReader::end_element);
    XML_SetStartDoctypeDeclHandler(
        parser_.get(), [](void* self, const XML_Char*, const XML_Char*, const XML_Char*, int) {
          static_cast<XmlReader*>(self)->stop("a document type", "XML of OpenStreetMap, which has none");
        });
  }

  OsmExtract run() {
    std::ifstream file(path_, std::ios::binary);
    if (!file) throw MapError(path_ + ": cannot be read");
    std::array<char, 1u << 16> block;
    std::size_t bytes = 0;
    for (bool is_last = false; !is_last;) {
      file.read(block.data(), block.size());
      bytes += static_cast<std::size_t>(file.gcount());
      if (bytes > JsonLimits{}.bytes)
        throw MapError(path_ + ": larger than 64 MiB, expected an extract of one building");
      is_last = file.gcount() < static_cast<std::streamsize>(block.size());
      if (XML_Parse(parser_.get(), block.data(), static_cast<int>(file.gcount()), is_last) == XML_STATUS_ERROR) fail();
    }
    return std::move(extract_);
  }

 private:
  [[noreturn]] void fail() const {
    const std::string what = complaint_.empty()
                                 ? std::string("not valid XML: ") + XML_ErrorString(XML_GetErrorCode(parser_.get()))
                                 : complaint_;
    throw MapError(fmt::format("{}:{}: {}", path_, XML_GetCurrentLineNumber(parser_.get()), what));
  }

  /// No exception may pass through a library in C.
  void stop(const std::string& found, const std::string& expected) {
    if (!complaint_.empty()) return;
    complaint_ = found + ", expected " + expected;
    XML_StopParser(parser_.get(), XML_FALSE);
  }

  static void begin_element(void* self, const XML_Char* name, const XML_Char** attributes) {
    auto& reader = *static_cast<XmlReader*>(self);
    if (reader.complaint_.empty()) reader.begin(name, attributes);
  }

  static void end_element(void* self, const XML_Char* name) {
    auto& reader = *static_cast<XmlReader*>(self);
    const std::string_view type = name;
    if (type == "member" && reader.inside_ == Inside::relation) reader.end_member();
    if (type == "way" && reader.inside_ == Inside::way) reader.end_way();
    if (type == "relation" && reader.inside_ == Inside::relation) reader.end_relation();
    if (type == "node" || type == "way" || type == "relation") reader.inside_ = Inside::nothing;
  }

  static const char* attribute(const XML_Char** attributes, const char* name) {
    for (; *attributes != nullptr; attributes += 2)
      if (std::strcmp(attributes[0], name) == 0) return attributes[1];
    return nullptr;
  }

  template <class Number>
  std::optional<Number> number(const XML_Char** attributes, const char* name, const char* element) {
    const char* text = attribute(attributes, name);
    if (text != nullptr)
      if (const auto value = parse_number<Number>(text)) return value;
    stop(fmt::format("{}: {}", element,
                     text == nullptr ? fmt::format("no {}", name) : fmt::format("{}=\"{}\"", name, text)),
         "a number");
    return std::nullopt;
  }

  void begin(std::string_view type, const XML_Char** attributes) {
    if (!has_root_ && type != "osm") return stop("the element " + std::string(type), "osm");
    has_root_ = true;
    if (type == "node" || type == "way" || type == "relation") return begin_object(type, attributes);
    if (inside_ == Inside::nothing) return;
    if (type == "tag") add_tag(attributes);
    if (type == "nd") add_node_of_way(attributes);
    if (type == "member" && inside_ == Inside::relation) add_member(attributes);
  }

  void begin_object(std::string_view type, const XML_Char** attributes) {
    const char *action = attribute(attributes, "action"), *visible = attribute(attributes, "visible");
    inside_ = Inside::nothing;
    if ((action != nullptr && std::strcmp(action, "delete") == 0) ||
        (visible != nullptr && std::strcmp(visible, "false") == 0))
      return;
    const auto id = number<std::int64_t>(attributes, "id", std::string(type).c_str());
    if (!id) return;
    if (type == "way") {
      way_ = &extract_.ways[*id];
      seen_ = {};
      tags_ = &way_->tags;
      inside_ = Inside::way;
    } else if (type == "relation") {
      relation_ = &extract_.relations[*id];
      members_.clear();
      tags_ = &relation_->tags;
      inside_ = Inside::relation;
    } else {
      begin_node(*id, attributes);
    }
  }

  void begin_node(std::int64_t id, const XML_Char** attributes) {
    const auto latitude = number<double>(attributes, "lat", "node");
    const auto longitude = number<double>(attributes, "lon", "node");
    if (!latitude || !longitude) return;
    OsmNode& node = extract_.nodes[id];
    node.position = {*longitude, *latitude};
    tags_ = &node.tags;
    inside_ = Inside::node;
  }

  /// "out geom" of Overpass states where a node is; one outside of the query's box is nowhere. In a relation it has no
  /// name.
  void add_node_of_way(const XML_Char** attributes) {
    constexpr std::int64_t kUnnamed = 0;
    const auto id = inside_ == Inside::way ? number<std::int64_t>(attributes, "ref", "nd") : kUnnamed;
    if (!id) return;
    seen_.nodes.push_back(*id);
    const char *latitude = attribute(attributes, "lat"), *longitude = attribute(attributes, "lon");
    if (latitude == nullptr || longitude == nullptr) return;
    const auto y = parse_number<double>(latitude), x = parse_number<double>(longitude);
    if (x && y) seen_.positions.emplace_back(*x, *y);
  }

  void take_positions(OsmWay& way) {
    if (!seen_.nodes.empty() && seen_.positions.size() == seen_.nodes.size())
      way.positions = std::move(seen_.positions);
  }

  /// The same object may come twice, with all that it has and without.
  void end_way() {
    take_positions(*way_);
    if (!seen_.nodes.empty()) way_->nodes = std::move(seen_.nodes);
  }

  void end_member() {
    if (!members_.empty() && members_.back().type == "way") take_positions(extract_.ways[members_.back().id]);
  }

  void end_relation() {
    if (!members_.empty()) relation_->members = std::move(members_);
  }

  void add_tag(const XML_Char** attributes) {
    const char *key = attribute(attributes, "k"), *value = attribute(attributes, "v");
    if (key == nullptr || value == nullptr) return stop("tag without k and v", "both");
    (*tags_)[key] = value;
  }

  void add_member(const XML_Char** attributes) {
    const char *type = attribute(attributes, "type"), *role = attribute(attributes, "role");
    const auto id = number<std::int64_t>(attributes, "ref", "member");
    if (id && type != nullptr) members_.push_back({type, role == nullptr ? "" : role, *id});
    seen_ = {};
  }

  enum class Inside { nothing, node, way, relation };
  const std::string& path_;
  std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser_;
  OsmExtract extract_;
  Inside inside_ = Inside::nothing;
  std::map<std::string, std::string>* tags_ = nullptr;
  OsmWay* way_ = nullptr;
  OsmWay seen_;  ///< what this element tells of it
  OsmRelation* relation_ = nullptr;
  std::vector<OsmMember> members_;  ///< of this element
  bool has_root_ = false;
  std::string complaint_;
};

}  // namespace

OsmExtract read_osm_xml(const std::string& path) { return XmlReader(path).run(); }

}  // namespace opal::geojson_importer
