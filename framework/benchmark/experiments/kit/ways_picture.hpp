#pragma once

#include <opal/map/semantic_map.hpp>

#include <string>
#include <vector>

namespace opal::experiments {

/// A building with the ways of robots through it (Hendrikx 2023, figures 3.9 and 4.10). Frame: `map`.
struct WaysPicture {
  struct Stretch {
    std::vector<Point> points;
    bool solid;  ///< otherwise dotted
  };
  struct Way {
    std::string name;
    std::vector<Stretch> stretches;
    std::vector<Point> marks;  ///< where it localized
    struct Star {
      Point from;
      std::vector<Point> to;
    };
    std::vector<Star> stars;      ///< places joined with what was seen from there
    std::vector<Point> estimate;  ///< drawn thin, if there is any
  };
  std::vector<Way> ways;  ///< a colour each
  std::vector<Point> goals;
  std::vector<Circle> regions;  ///< known at first, drawn red
};

/// SVG to be put into a page; says its colours in a list beside the picture.
std::string svg_of(const SemanticMap& map, const WaysPicture& picture);

}  // namespace opal::experiments
