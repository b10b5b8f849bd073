#pragma once

#include "closed_loop/closed_loop.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace opal::cli {

/// What a robot was asked to do.
struct DriveTask {
  std::uint64_t seed = 0;
  Pose2 start;  ///< T_map_base, which it is not told
  Point goal;
  std::vector<Geometry> unmapped = {};  ///< for the picture
};

/// Drives with what became of them: one line each on stdout, summary.json, and pictures of the first few and of those
/// that failed.
class DriveReport {
 public:
  DriveReport(std::shared_ptr<const SemanticMap> map, std::string behaviour, std::filesystem::path out)
      : map_(std::move(map)), behaviour_(std::move(behaviour)), out_(std::move(out)) {}

  void add(const DriveTask& task, const DriveRecord& record);
  void write() const;
  std::size_t drives() const { return runs_.size(); }
  bool all_reached() const { return reached_ == static_cast<int>(runs_.size()); }

 private:
  void draw(const DriveTask& task, const DriveRecord& record) const;
  nlohmann::ordered_json totals() const;

  std::shared_ptr<const SemanticMap> map_;
  std::string behaviour_;
  std::filesystem::path out_;
  nlohmann::ordered_json runs_ = nlohmann::ordered_json::array();
  int reached_ = 0, localized_ = 0, falsely_localized_ = 0;
  std::size_t collisions_ = 0;
  std::vector<double> localized_after_m_, times_s_;
};

}  // namespace opal::cli
