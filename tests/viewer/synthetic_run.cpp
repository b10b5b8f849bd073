#include "synthetic_run.hpp"

#include <opal/common/geometry.hpp>

#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>
#include <random>

namespace opal::synthetic {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kWidth_m = 40, kDepth_m = 24, kStep_m = 0.2, kPeriod_s = 0.25, kStart_s = 1000;
constexpr double kTurn = 2 * std::numbers::pi;
constexpr int kColumns = 12;

Json json_of(const Pose2& pose) { return {pose.x(), pose.y(), pose.heading_rad()}; }

/// Where the robot is after some metres of an ellipse round the hall.
Pose2 on_the_way(double metres) {
  const double angle = metres / 12;
  const Point p(kWidth_m / 2 + 14 * std::cos(angle), kDepth_m / 2 + 7 * std::sin(angle));
  return {p, std::atan2(7 * std::cos(angle), -14 * std::sin(angle))};
}

Circle column(int k) { return {{4.0 + 6.0 * (k % 6), k < 6 ? 8.0 : 16.0}, 0.3}; }

/// Range of a beam in the hall.
double range_m(const Point& from, const Point& direction) {
  double range = 1e9;
  if (direction.x() != 0) range = std::min(range, ((direction.x() > 0 ? kWidth_m : 0) - from.x()) / direction.x());
  if (direction.y() != 0) range = std::min(range, ((direction.y() > 0 ? kDepth_m : 0) - from.y()) / direction.y());
  for (int k = 0; k < kColumns; ++k) {
    const Point to = column(k).center - from;
    const double along = to.dot(direction), aside = cross(direction, to), radius = column(k).radius_m;
    if (along > 0 && std::abs(aside) < radius)
      range = std::min(range, along - std::sqrt(radius * radius - aside * aside));
  }
  return range;
}

struct Alternative {
  int id = 0;
  Pose2 T_map_base;
  double nat = 0;
  std::vector<int> known;  ///< local features that it has associated
};

class Run {
 public:
  Run(const RunSize& size, EventSink& events) : size_(size), events_(events), random_(size.seed) {}

  void write() {
    write_header();
    for (int line = 0; line < size_.time_lines; ++line) {
      begin_time_line(line);
      const int updates = size_.updates / size_.time_lines;
      for (int k = 0; k < updates; ++k) write_update(k);
    }
  }

 private:
  double uniform(double least, double most) { return std::uniform_real_distribution<>(least, most)(random_); }
  double normal(double sigma) { return std::normal_distribution<>(0, sigma)(random_); }

  Json event(const char* kind) const { return {{"event", kind}, {"stamp_s", stamp_s_}, {"keyframe", keyframe_}}; }

  void write_header() {
    events_.write({{"event", "run"},
                   {"format", 3},
                   {"opal", "0.1.0"},
                   {"log", "hall.log.gz"},
                   {"config", "default.jsonld"},
                   {"map", "hall.jsonld"},
                   {"sensor", "PlanarLidar2D"},
                   {"T_base_laser", {0.1, 0, 0}},
                   {"range_max_m", 30}});
    Json objects = Json::array(), features = Json::array(), pattern = Json::array();
    const Point corners[] = {{0, 0}, {kWidth_m, 0}, {kWidth_m, kDepth_m}, {0, kDepth_m}};
    for (int k = 0; k < 4; ++k) {
      const Point a = corners[k], b = corners[(k + 1) % 4];
      objects.push_back({"wall-" + std::to_string(k), "opal:Wall"});
      features.push_back({{"id", "wall-" + std::to_string(k) + "/face"},
                          {"object", k},
                          {"type", "opal:Wall"},
                          {"perceivable", true},
                          {"segment", {a.x(), a.y(), b.x(), b.y()}}});
    }
    for (int k = 0; k < kColumns; ++k) {
      const std::string id = "column-" + std::to_string(k);
      const Circle circle = column(k);
      objects.push_back({id, "opal:Column"});
      features.push_back({{"id", id + "/rim"},
                          {"object", 4 + k},
                          {"type", "opal:Column"},
                          {"perceivable", true},
                          {"circle", {circle.center.x(), circle.center.y(), circle.radius_m}}});
      pattern.push_back(id + "/rim");
    }
    events_.write({{"event", "map"},
                   {"name", "hall"},
                   {"objects", objects},
                   {"features", features},
                   {"patterns", {{{"id", "row"}, {"template", "opal:Row"}, {"features", pattern}}}}});
  }

  void begin_time_line(int line) {
    alternatives_.clear();
    local_.clear();
    metres_ = 3.0 * line;
    keyframe_ = 0;
    T_odom_drift_ = {};
    T_map_local_ = on_the_way(metres_);
    stamp_s_ = kStart_s + 1e4 * line;
    events_.write({{"event", "start"}, {"query", "q" + std::to_string(line)}});
    Json poses = Json::array();
    const int updates = size_.updates / size_.time_lines;
    for (int k = 0; k < updates; k += 2) {
      const Pose2 pose = on_the_way(metres_ + kStep_m * k);
      poses.push_back({stamp_s_ + kPeriod_s * k, pose.x(), pose.y(), pose.heading_rad()});
    }
    events_.write({{"event", "truth"}, {"poses", poses}});
  }

  void write_update(int k) {
    keyframe_ = k;
    const Pose2 before = truth_;
    truth_ = on_the_way(metres_);
    step_ = k == 0 ? Pose2() : before.inverse() * truth_;
    T_odom_drift_ = Pose2(normal(0.002), normal(0.002), normal(0.0005)) * T_odom_drift_;
    T_local_base_ = T_map_local_.inverse() * truth_ * T_odom_drift_;
    write_scan();
    write_local_features();
    for (Alternative& alternative : alternatives_) move(alternative);
    end_some();
    bear_some();
    grow_some();
    write_estimate();
    auto cost = event("cost");
    cost["cpu_ms"] = {{"detect", uniform(0.1, 0.3)}, {"track", uniform(1, 3)}, {"total", uniform(3, 4)}};
    events_.write(cost);
    metres_ += kStep_m;
    stamp_s_ += kPeriod_s;
  }

  void write_scan() {
    auto e = event("keyframe");
    e["T_local_base"] = json_of(T_local_base_);
    e["points"] = size_.points;
    e["scan_match"] = keyframe_ % 7 != 6;
    auto &scan = e["scan"] = Json::array(), &free = e["free_space"] = Json::array();
    for (int k = 0; k < size_.points; ++k) {
      const Point direction = unit_vector(kTurn * k / size_.points - std::numbers::pi);
      const double range = range_m(truth_.position(), truth_.rotate(direction)) + normal(0.01);
      scan.push_back(range * direction.x());
      scan.push_back(range * direction.y());
      if (k % 6 != 0) continue;
      free.push_back((range - 0.05) * direction.x());
      free.push_back((range - 0.05) * direction.y());
    }
    events_.write(e);
  }

  Json local_row(int id) {
    const Pose2 T_local_map = T_local_base_ * truth_.inverse();
    const Point p = T_local_map * column(id % kColumns).center;
    return {{"id", id},
            {"type", "opal:Column"},
            {"stable", id % 3 != 0},
            {"measurements", 3 + keyframe_ % 40},
            {"circle", {p.x() + normal(0.005), p.y() + normal(0.005), 0.3 + normal(0.002)}}};
  }

  void write_local_features() {
    Json changed = Json::array(), gone = Json::array();
    if (keyframe_ % 10 == 0) {
      const int id = next_local_++;
      local_.push_back(id);
      if (local_.size() > 30) {
        gone.push_back(local_.front());
        local_.pop_front();
      }
      auto e = event("stable");
      e["local_feature"] = id;
      e["type"] = "opal:Column";
      stable_ = e;
    }
    for (std::size_t k = 0; k < local_.size(); k += 5) changed.push_back(local_row(local_[k]));
    if (keyframe_ % 10 == 0 && local_.back() != local_[(local_.size() - 1) / 5 * 5])
      changed.push_back(local_row(local_.back()));
    auto e = event("local_features");
    e["changed"] = changed;
    e["gone"] = gone;
    events_.write(e);
    if (keyframe_ % 10 == 0) events_.write(stable_);
  }

  void move(Alternative& alternative) {
    alternative.T_map_base = alternative.T_map_base * step_ * Pose2(normal(0.006), normal(0.006), normal(0.002));
    if (alternative.id == alternatives_.front().id)
      alternative.T_map_base = truth_ * Pose2(normal(0.01), normal(0.01), normal(0.002));
    alternative.nat = 0.98 * alternative.nat + normal(0.3) + (alternative.id == alternatives_.front().id ? 0.4 : 0.1);
  }

  Json scores() {
    return {{"opal:FreeSpaceScorer", {{"beams", uniform(-4, 4)}, {"through_walls", uniform(-2, 0)}}},
            {"opal:InlierScorer", {{"inliers", uniform(0, 5)}}}};
  }

  Json findings() {
    return {{{"scorer", "opal:FreeSpaceScorer"},
             {"words", "beam 221 passes 1.8 m through wall-1"},
             {"map_feature", "wall-1/face"},
             {"line", {truth_.x(), truth_.y(), kWidth_m, 10.0}}}};
  }

  void end_some() {
    const int count = static_cast<int>(alternatives_.size()) / 40;
    for (int k = 0; k < count; ++k) {
      const std::size_t which = 1 + random_() % (alternatives_.size() - 1);
      const Alternative& alternative = alternatives_[which];
      auto e = event("pruned");
      e["hypothesis"] = alternative.id;
      e["reason"] = k % 2 == 0 ? "worse than the best by more than 17 nat" : "same place as the best";
      if (k % 2 == 1) e["merged_into"] = alternatives_.front().id;
      e["T_map_base"] = json_of(alternative.T_map_base);
      e["log_likelihood"] = alternative.nat;
      e["scan_nat"] = uniform(-3, 1);
      e["scores"] = scores();
      e["findings"] = findings();
      events_.write(e);
      alternatives_.erase(alternatives_.begin() + static_cast<std::ptrdiff_t>(which));
    }
  }

  void bear_some() {
    if (static_cast<int>(alternatives_.size()) >= size_.hypotheses) return;
    auto search = event("searched");
    search["patterns"] = {
        {{"template", "opal:Row"}, {"local_features", {local_.front(), local_.back()}}, {"candidates", 40}}};
    search["proposed"] = 12;
    search["rejected"] = {{{"template", "opal:Row"},
                           {"T_map_base", {5, 5, 1}},
                           {"pairs", {{local_.front(), "column-1/rim"}}},
                           {"nat", -2.5},
                           {"reason", "beams pass through wall-2"}}};
    events_.write(search);
    while (static_cast<int>(alternatives_.size()) < size_.hypotheses) {
      Alternative alternative{next_hypothesis_++,
                              {uniform(1, kWidth_m - 1), uniform(1, kDepth_m - 1), uniform(-3, 3)},
                              alternatives_.empty() ? 5.0 : uniform(-3, 2),
                              {}};
      if (alternatives_.empty()) alternative.T_map_base = truth_;
      auto e = event("spawned");
      e["hypothesis"] = alternative.id;
      if (alternative.id % 3 == 1) e["parent"] = alternatives_.front().id;
      e["template"] = "opal:Row";
      e["T_map_base"] = json_of(alternative.T_map_base);
      e["log_likelihood"] = alternative.nat;
      e["pairs"] = Json::array();
      associate(alternative, local_.back(), e["pairs"]);
      events_.write(e);
      alternatives_.push_back(std::move(alternative));
    }
  }

  void associate(Alternative& alternative, int local, Json& pairs) {
    const bool on_map = alternative.id % 5 != 4;
    pairs.push_back({local, on_map ? Json("column-" + std::to_string((local + alternative.id) % kColumns) + "/rim")
                                   : Json(nullptr)});
    alternative.known.push_back(local);
  }

  void grow_some() {
    for (std::size_t k = 0; k < alternatives_.size(); k += 10) {
      Alternative& alternative = alternatives_[k];
      if (std::ranges::find(alternative.known, local_.back()) != alternative.known.end()) continue;
      auto grown = event("associated");
      grown["hypothesis"] = alternative.id;
      associate(alternative, local_.back(), grown["pairs"]);
      events_.write(grown);
      if (alternative.known.size() > 20) {
        auto lost = event("dissociated");
        lost["hypothesis"] = alternative.id;
        lost["local_features"] = {alternative.known.front()};
        lost["reason"] = "the local feature is gone";
        alternative.known.erase(alternative.known.begin());
        events_.write(lost);
      }
      auto tried = event("rejected");
      tried["hypothesis"] = alternative.id;
      tried["pairs"] = {{local_.back(), "column-2/rim"}};
      tried["reason"] = "0.7 m off";
      events_.write(tried);
    }
  }

  void write_estimate() {
    const bool sure = keyframe_ > 5;
    auto e = event("estimate");
    e["status"] = sure ? "localized" : "ambiguous";
    e["probability"] = sure ? 0.98 : 0.4;
    e["none"] = 0.01;
    e["hypothesis"] = alternatives_.front().id;
    e["T_map_base"] = json_of(alternatives_.front().T_map_base);
    auto& rows = e["hypotheses"] = Json::array();
    for (std::size_t k = 0; k < alternatives_.size(); ++k)
      rows.push_back({{"hypothesis", alternatives_[k].id},
                      {"T_map_base", json_of(alternatives_[k].T_map_base)},
                      {"log_likelihood", alternatives_[k].nat},
                      {"scan_nat", uniform(-3, 3)},
                      {"probability", k == 0 ? (sure ? 0.98 : 0.4) : 0.01 / double(k * k)},
                      {"scores", scores()}});
    e["findings"] = findings();
    events_.write(e);
    if (keyframe_ != 0 && keyframe_ != 6) return;
    auto status = event("status");
    status["status"] = e["status"];
    status["probability"] = e["probability"];
    status["hypothesis"] = e["hypothesis"];
    events_.write(status);
  }

  const RunSize size_;
  EventSink& events_;
  std::mt19937 random_;
  std::vector<Alternative> alternatives_;
  std::deque<int> local_;
  Json stable_;
  int next_hypothesis_ = 0, next_local_ = 0, keyframe_ = 0;
  double metres_ = 0, stamp_s_ = kStart_s;
  Pose2 truth_, step_, T_odom_drift_, T_map_local_, T_local_base_;
};

}  // namespace

void write_run(const RunSize& size, EventSink& events) { Run(size, events).write(); }

}  // namespace opal::synthetic
