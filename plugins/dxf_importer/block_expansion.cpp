#include "block_expansion.hpp"

#include <opal/common/error.hpp>
#include <opal/common/letter_case.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace opal::dxf_importer {
namespace {

constexpr std::size_t kMaxEntities = 300'000;
constexpr std::size_t kMaxDepth = 32;

class Expansion {
 public:
  Expansion(const std::string& path, const DxfDrawing& drawing) : path_(path), drawing_(drawing) {}

  std::vector<PlacedEntity> run() {
    for (const DxfEntity& entity : drawing_.entities) place(entity, {});
    return std::move(placed_);
  }

 private:
  /// @param frame  where the entity's coordinates lie, and what it takes from the INSERTs around it.
  void place(const DxfEntity& entity, PlacedEntity frame) {
    if (++count_ > kMaxEntities) fail_too_many();
    frame.entity = &entity;
    if (frame.insert.empty() || entity.layer != "0") frame.layer = entity.layer;
    if (const auto layer = drawing_.layers.find(entity.layer); layer != drawing_.layers.end())
      frame.is_frozen |= layer->second.is_frozen;
    if (frame.damage.empty()) frame.damage = entity.damage;
    const auto* insert = std::get_if<DxfInsert>(&entity.shape);
    if (insert != nullptr && !entity.is_in_paper_space)
      place_block(*insert, std::move(frame));
    else
      placed_.push_back(std::move(frame));
  }

  void place_block(const DxfInsert& insert, PlacedEntity frame) {
    const std::string name = upper_case_letters(insert.block);
    const auto block = drawing_.blocks.find(name);
    if (block == drawing_.blocks.end())
      frame.trouble = "its block '" + insert.block + "' is not in the file";
    else if (block->second.is_external)
      frame.trouble = "its block '" + insert.block + "' stands for another file (bind the reference)";
    else if (insert.scale.x() == 0 || insert.scale.y() == 0)
      frame.trouble = "it is scaled to nothing";
    if (!frame.trouble.empty()) {
      placed_.push_back(std::move(frame));
      return;
    }
    if (frame.damage.empty()) frame.damage = block->second.damage;
    check_depth(name);
    open_.push_back(name);
    const std::size_t before = placed_.size();
    for (int row = 0; row < std::max(1, insert.rows); ++row)
      for (int column = 0; column < std::max(1, insert.columns); ++column)
        place_cell(insert, block->second, frame, column, row);
    open_.pop_back();
    if (placed_.size() != before) return;
    frame.trouble = "its block '" + insert.block + "' is empty";
    placed_.push_back(std::move(frame));
  }

  void place_cell(const DxfInsert& insert, const DxfBlock& block, const PlacedEntity& around, int column, int row) {
    ++count_;  // an array of an empty block has an end, too
    if (count_ > kMaxEntities) fail_too_many();
    PlacedEntity frame = around;
    const bool is_array = insert.rows > 1 || insert.columns > 1;
    frame.insert += (frame.insert.empty() ? "" : "/") + around.entity->id;
    if (is_array) frame.insert += fmt::format("[{},{}]", column, row);
    frame.inserts.emplace_back(frame.insert, frame.layer);
    frame.blocks.push_back(insert.block);
    frame.T_drawing_entity = around.T_drawing_entity * Eigen::Translation2d(insert.position) *
                             Eigen::Rotation2Dd(insert.rotation_rad) *
                             Eigen::Translation2d(column * insert.spacing.x(), row * insert.spacing.y()) *
                             Eigen::AlignedScaling2d(insert.scale) * Eigen::Translation2d(-block.base);
    for (const DxfEntity& entity : block.entities) place(entity, frame);
  }

  [[noreturn]] void fail_too_many() const {
    throw MapError(fmt::format(
        "{}: more than {} entities when all blocks are in place, at block '{}', expected a plan of one storey", path_,
        kMaxEntities, open_.empty() ? "" : open_.back()));
  }

  void check_depth(const std::string& name) const {
    const auto same = std::find(open_.begin(), open_.end(), name);
    if (same == open_.end() && open_.size() < kMaxDepth) return;
    std::string way;
    for (auto block = same == open_.end() ? open_.begin() : same; block != open_.end(); ++block)
      way += "'" + *block + "' > ";
    throw MapError(fmt::format(
        "{}: block {}'{}': {}, expected blocks that end", path_, way, name,
        same == open_.end() ? fmt::format("more than {} inside each other", kMaxDepth) : "it contains itself"));
  }

  const std::string& path_;
  const DxfDrawing& drawing_;
  std::vector<PlacedEntity> placed_;
  std::vector<std::string> open_;
  std::size_t count_ = 0;
};

}  // namespace

std::vector<PlacedEntity> expand_blocks(const std::string& path, const DxfDrawing& drawing) {
  return Expansion(path, drawing).run();
}

}  // namespace opal::dxf_importer
