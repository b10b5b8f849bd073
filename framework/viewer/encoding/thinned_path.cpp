#include "viewer/encoding/thinned_path.hpp"

namespace opal {

void ThinnedPath::add(const Point& p_map) {
  const bool is_jump = lines_.empty() || (p_map - newest_).norm() > kJump_m;
  newest_ = p_map;
  if (is_jump) {
    lines_.push_back({p_map});
    ++points_;
  } else if (std::vector<Point>& line = lines_.back();
             line.size() >= 2 && (p_map - line[line.size() - 2]).norm() < apart_m_) {
    line.back() = p_map;  // the newest place stands for those that were near
  } else {
    line.push_back(p_map);
    ++points_;
  }
  while (points_ > most_) thin();
}

std::vector<Point> ThinnedPath::thinned(const std::vector<Point>& line) const {
  std::vector<Point> kept{line.front()};
  for (std::size_t k = 1; k + 1 < line.size(); ++k)
    if ((line[k] - kept.back()).norm() >= apart_m_) kept.push_back(line[k]);
  if (line.size() > 1) kept.push_back(line.back());
  return kept;
}

/// Half of the points may be ends of lines; the oldest lines go, if there are more.
void ThinnedPath::thin() {
  apart_m_ *= 2;
  points_ = 0;
  for (std::vector<Point>& line : lines_) points_ += (line = thinned(line)).size();
  std::size_t drop = 0;
  for (; 2 * 2 * (lines_.size() - drop) > most_ && drop + 1 < lines_.size(); ++drop) points_ -= lines_[drop].size();
  lines_.erase(lines_.begin(), lines_.begin() + static_cast<std::ptrdiff_t>(drop));
}

}  // namespace opal
