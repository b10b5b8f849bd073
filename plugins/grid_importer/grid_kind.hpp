#pragma once

namespace opal::grid_importer {

/// Where a grid comes from: a laser, or a plan that was drawn along its rows and columns.
enum class GridKind { recorded, drawn };

}  // namespace opal::grid_importer
