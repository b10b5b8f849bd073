#include "dxf_curves.hpp"
#include "dxf_drawing.hpp"
#include "dxf_record_check.hpp"
#include "entity_shape.hpp"

#include <opal/common/error.hpp>
#include <opal/common/letter_case.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>

namespace opal::dxf_importer {
namespace {

constexpr int kThreeDimensionalMesh = 16 | 64;
constexpr int kExternalBlock = 4 | 8;

/// Entities of planes that face down are mirrored: x of their own coordinates runs the other way.
void apply_extrusion(const DxfRecord& record, DxfEntity& entity) {
  const Point across(record.real(210, 0), record.real(220, 0));
  const double up = record.real(230, 1);
  if (across.norm() > 1e-6 * std::abs(up)) entity.trouble = "its plane is tilted against the plan";
  if (up >= 0 || record.type == "LINE" || is_curve(record.type)) return;
  const auto mirror = [](Point& p) { p.x() = -p.x(); };
  const auto mirror_all = [&](std::vector<DxfVertex>& vertices) {
    for (DxfVertex& v : vertices) {
      mirror(v.position);
      v.bulge = -v.bulge;
    }
  };
  if (auto* p = std::get_if<DxfPath>(&entity.shape)) mirror_all(p->vertices);
  if (auto* c = std::get_if<Circle>(&entity.shape)) mirror(c->center);
  if (auto* f = std::get_if<DxfFill>(&entity.shape))
    for (auto& loop : f->loops) mirror_all(loop);
  if (auto* a = std::get_if<DxfArc>(&entity.shape)) {
    mirror(a->circle.center);
    a->from_rad = std::numbers::pi - a->from_rad - a->sweep_rad;
  }
  if (auto* i = std::get_if<DxfInsert>(&entity.shape)) {
    mirror(i->position);
    i->rotation_rad = -i->rotation_rad;
    i->scale.x() = -i->scale.x();
    i->spacing.x() = -i->spacing.x();
  }
}

/// Of a polyline; 0 if it is not the same everywhere. Each vertex may say how wide the line begins and ends there.
double width_of(const DxfEntityRecords& records) {
  const DxfRecord& head = records.head;
  if (head.type != "LWPOLYLINE" && head.type != "POLYLINE") return 0;
  if (const DxfPair* constant = head.find(43); constant != nullptr) return std::max(0.0, constant->real());
  double least = std::numeric_limits<double>::max(), most = 0;
  const auto take = [&](const DxfRecord& record) {
    for (const DxfPair& pair : record.pairs)
      if (pair.code == 40 || pair.code == 41) {
        least = std::min(least, pair.real());
        most = std::max(most, pair.real());
      }
  };
  take(head);
  for (const DxfRecord& part : records.parts) take(part);
  return least < most ? 0 : most;
}

class Reader {
 public:
  explicit Reader(const std::string& path) : path_(path), scan_(scan_dxf(path)) {}

  DxfDrawing run() {
    drawing_.insunits = scan_.insunits;
    drawing_.layers = scan_.layers;
    drawing_.clips = scan_.clips;
    drawing_.lines_after_end = scan_.lines_after_end;
    drawing_.lacks_end = scan_.lacks_end;
    drawing_.entities = entities(scan_.entities);
    read_blocks();
    name_clipped();
    return std::move(drawing_);
  }

 private:
  [[noreturn]] void fail(int line, const std::string& complaint) const {
    throw MapError(fmt::format("{}:{}: {}", path_, line, complaint));
  }

  /// "2A5 'PLAN-EAST'" of each INSERT that is clipped.
  void name_clipped() {
    std::map<std::string, std::string> block_of;
    for (const auto* records : {&scan_.entities, &scan_.blocks})
      for (const DxfRecord& record : *records)
        if (record.type == "INSERT") block_of.emplace(record.text(5), record.text(2));
    for (const std::string& handle : scan_.clipped)
      if (const auto block = block_of.find(handle); block != block_of.end())
        drawing_.clipped.push_back(fmt::format("{} '{}'", handle, block->second));
  }

  using Record = std::vector<DxfRecord>::const_iterator;

  void read_blocks() {
    std::map<std::string, Record> first;
    for (Record begin = scan_.blocks.begin(); begin != scan_.blocks.end();) {
      const Record end = end_of_block(begin);
      const std::string name = upper_case_letters(begin->text(2));
      if (name.empty()) fail(begin->line, "a block without a name (code 2), expected one");
      if (const auto [known, is_new] = first.emplace(name, begin); is_new)
        read_block(name, begin, end);
      else
        repeat_block(name, known->second, begin);
      begin = end + 1;
    }
  }

  Record end_of_block(Record begin) const {
    return std::find_if(begin, scan_.blocks.cend(), [](const DxfRecord& record) { return record.type == "ENDBLK"; });
  }

  void read_block(const std::string& name, Record begin, Record end) {
    DxfBlock block;
    for (const int code : {10, 20})
      if (!is_place(begin->real(code, 0)))
        block.damage =
            fmt::format("{}:{}: {}: code {} is no number of at most 1e12", path_, begin->line, begin->type, code);
    block.base = {begin->real(10, 0), begin->real(20, 0)};
    block.is_external = (flags_of(*begin) & kExternalBlock) != 0;
    block.entities = entities({begin + 1, end});
    drawing_.blocks.emplace(name, std::move(block));
  }

  /// The first block counts. One that differs makes every use of the name doubtful.
  void repeat_block(const std::string& name, Record first, Record second) {
    drawing_.repeated_blocks.push_back(fmt::format("{} (line {})", second->text(2), second->line));
    if (!std::equal(first, end_of_block(first), second, end_of_block(second), draws_the_same))
      drawing_.blocks.at(name).damage = fmt::format(
          "{}:{}: a second block '{}' that differs from the one at line {}, expected one block of this name", path_,
          second->line, second->text(2), first->line);
  }

  /// Apart from names of blocks and from handles.
  static bool draws_the_same(const DxfRecord& a, const DxfRecord& b) {
    const auto content = [](const DxfRecord& record) {
      std::vector<std::pair<int, std::string>> pairs;
      for (const DxfPair& pair : record.pairs) {
        const bool is_name = record.type == "BLOCK" && (pair.code < 10 && pair.code != 8);
        const bool is_handle = pair.code == 5 || pair.code == 102 || (pair.code >= 320 && pair.code < 370);
        if (!is_name && !is_handle) pairs.emplace_back(pair.code, pair.value);
      }
      return pairs;
    };
    return a.type == b.type && content(a) == content(b);
  }

  static bool is_place(double coordinate) { return std::isfinite(coordinate) && std::abs(coordinate) <= 1e12; }

  std::vector<DxfEntity> entities(const std::vector<DxfRecord>& records) {
    std::vector<DxfEntity> entities;
    for (std::size_t k = 0; k < records.size();) {
      DxfEntityRecords entity{records[k], {}};
      ++k;
      const bool has_parts =
          entity.head.type == "POLYLINE" || (entity.head.type == "INSERT" && entity.head.text(66) == "1");
      while (has_parts && k < records.size() && is_part(records[k].type)) {
        entity.parts.push_back(records[k++]);
        if (entity.parts.back().type == "SEQEND") break;
      }
      const bool is_open = has_parts && (entity.parts.empty() || entity.parts.back().type != "SEQEND");
      entities.push_back(read(entity, is_open));
    }
    return entities;
  }

  static bool is_part(const std::string& type) { return type == "VERTEX" || type == "ATTRIB" || type == "SEQEND"; }

  /// @param is_open  the records that belong to it end without SEQEND.
  DxfEntity read(const DxfEntityRecords& records, bool is_open) {
    const DxfRecord& head = records.head;
    DxfEntity entity{head.type, id_of(head), head.text(8, "0"), head.text(67) == "1", head.text(60) == "1", "", "", {}};
    if (!is_understood(head.type)) return entity;
    if (head.type == "POLYLINE" && (flags_of(head) & kThreeDimensionalMesh) != 0) {
      entity.trouble = "a mesh in space";
      return entity;
    }
    try {
      if (is_open) fail(head.line, head.type + " without SEQEND, expected one at its end");
      read_shape_of(records, entity);
    } catch (const MapError& error) {
      entity.damage = error.what();
      entity.shape = std::monostate();
      if (head.type == "INSERT") entity.shape = DxfInsert{head.text(2)};
    }
    return entity;
  }

  void read_shape_of(const DxfEntityRecords& records, DxfEntity& entity) const {
    const DxfRecord& head = records.head;
    check_records(path_, records);
    entity.shape = is_curve(head.type) ? read_curve(head, entity.trouble) : read_shape(path_, records, entity.trouble);
    if (auto* line = std::get_if<DxfPath>(&entity.shape)) line->width = width_of(records);
    apply_extrusion(head, entity);
    if (!entity.trouble.empty()) entity.shape = std::monostate();
  }

  std::string id_of(const DxfRecord& record) {
    std::string id = record.text(5);
    const bool is_usable = !id.empty() && id.size() <= 16 &&
                           std::all_of(id.begin(), id.end(), [](unsigned char c) { return std::isxdigit(c) != 0; });
    const std::string place = fmt::format("line-{}", record.line);
    if (!is_usable) id = place;
    if (!ids_.insert(id).second) ids_.insert(id += "-" + place);
    return id;
  }

  const std::string& path_;
  DxfScan scan_;
  DxfDrawing drawing_;
  std::set<std::string> ids_;
};

}  // namespace

DxfDrawing read_dxf(const std::string& path) { return Reader(path).run(); }

}  // namespace opal::dxf_importer
