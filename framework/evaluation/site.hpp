#pragma once

#include <opal/sensing/scan.hpp>

#include <string>
#include <vector>

namespace opal {

/// One task of a benchmark: localize from scratch with the log records of [start_s, end_s] only.
struct Query {
  std::string id;
  double start_s = 0;
  double end_s = 0;
};

/// The laser of a recorded site, from PREFIX.info.json: `n_beams`, `angle_min_deg`, `angle_increment_deg`,
/// `no_return_at_or_above_m`, `offset_x_m`, `offset_y_m`, `offset_theta` [rad] of its member `laser`; if they are
/// there, `sweep_s`, and `range_max_m`: how far the laser sees. Other members are descriptive and not looked at.
/// Returns farther than 30 m are not used.
/// @throws Error naming the file, the JSON pointer, what was found and what was expected.
OPAL_EXPORT LaserModel read_site_laser(const std::string& path);

/// The queries of a recorded site, from PREFIX.queries.json, in file order.
/// @throws Error as above; also for ids that occur twice and windows that end before they start.
OPAL_EXPORT std::vector<Query> read_queries(const std::string& path);

}  // namespace opal
