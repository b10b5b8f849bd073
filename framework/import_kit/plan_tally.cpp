#include <opal/import_kit/plan_assembly.hpp>

#include <fmt/format.h>

namespace opal {

std::vector<std::string> PlanTally::sentences(const PlanOptions& options) const {
  std::vector<std::string> all;
  const auto add = [&](double amount, const std::string& text) {
    if (amount > 0) all.push_back(text);
  };
  add(outlines_m,
      fmt::format("{:.1f} m of line seen from one side: massive on the other by an outline or a column", outlines_m));
  add(pairs_m,
      fmt::format("{:.1f} m of line seen from one side: the wall's other face runs beside it, at most {:g} m away",
                  pairs_m, options.max_wall_thickness_m));
  add(two_sided_m, fmt::format("{:.1f} m of line seen from both sides: nothing says which", two_sided_m));
  add(hidden_m, fmt::format("left out: {:.1f} m of line inside of walls or where things touch", hidden_m));
  add(repeated_m, fmt::format("merged: {:.1f} m of line drawn more than once", repeated_m));
  add(short_faces, fmt::format("left out: {} faces shorter than {:g} m, together {:.2f} m", short_faces,
                               options.min_face_m, short_m));
  return all;
}

}  // namespace opal
