#pragma once

namespace opal::grid_importer {

/// What makes a wall face or a column, as the importer's options say it; see plugin.jsonld.
struct VectorizerLimits {
  double bridge_gap_m = 0.6;
  double line_tolerance_m = 0.08;
  double min_face_m = 0.15;
  double max_column_radius_m = 0.6;
  double thicken_m = 0;
};

}  // namespace opal::grid_importer
