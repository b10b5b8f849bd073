#include "evaluation/results.hpp"

#include "common/csv_table.hpp"

#include <algorithm>
#include <charconv>
#include <ostream>

namespace opal {
namespace {

// Nanoseconds of today's clocks, in so far as a double has them; micrometres.
constexpr int kDecimals = 9;
constexpr double kFar = 1e12;

/// Always with a point, whatever the locale says.
void append(std::string& line, std::initializer_list<double> numbers) {
  for (const double number : numbers) {
    char digits[400];  // the largest double has 309 before its point
    const auto end = std::to_chars(digits, digits + sizeof digits, number, std::chars_format::fixed, kDecimals).ptr;
    line.append(",").append(digits, end);
  }
}

bool is_finite(double stamp_s, const Pose2& pose, double probability) {
  return std::isfinite(stamp_s) && pose.position().allFinite() && std::isfinite(pose.heading_rad()) &&
         std::isfinite(probability);
}

Status status_named(const CsvTable& table) {
  for (const Status status : {Status::searching, Status::ambiguous, Status::localized, Status::lost})
    if (table.text("status") == name_of(status)) return status;
  table.refuse("status", "searching, ambiguous, localized or lost");
}

double stamp_in(const CsvTable& table) { return table.number("timestamp", -kFar, kFar); }
double share_in(const CsvTable& table, const std::string& column) { return table.number(column, 0, 1); }
Pose2 pose_in(const CsvTable& table) {
  return {table.number("x", -kFar, kFar), table.number("y", -kFar, kFar), table.number("theta", -kFar, kFar)};
}

}  // namespace

void write_results(std::ostream& out, std::span<const ResultRow> rows) {
  const bool has_storeys = std::any_of(rows.begin(), rows.end(), [](const ResultRow& r) { return !r.storey.empty(); });
  out << "query_id,timestamp,x,y,theta,localized_flag,probability,none,status" << (has_storeys ? ",storey\n" : "\n");
  for (const ResultRow& row : rows) {
    const Pose2& pose = row.T_map_laser;
    if (!is_finite(row.stamp_s, pose, row.probability + row.none)) continue;
    std::string line = csv_field(row.query);
    append(line, {row.stamp_s, pose.x(), pose.y(), pose.heading_rad()});
    line += row.localized() ? ",1" : ",0";
    append(line, {row.probability, row.none});
    out << line << ',' << name_of(row.status);
    if (has_storeys) out << ',' << csv_field(row.storey);
    out << '\n';
  }
}

void write_alternatives(std::ostream& out, std::span<const AlternativeRow> rows) {
  out << "query_id,timestamp,x,y,theta,probability\n";
  for (const AlternativeRow& row : rows) {
    const Pose2& pose = row.T_map_laser;
    if (!is_finite(row.stamp_s, pose, row.probability)) continue;
    std::string line = csv_field(row.query);
    append(line, {row.stamp_s, pose.x(), pose.y(), pose.heading_rad(), row.probability});
    out << line << '\n';
  }
}

std::vector<ResultRow> read_results(const std::string& path) {
  CsvTable table(path, {"query_id", "timestamp", "x", "y", "theta", "probability", "none", "status"});
  std::vector<ResultRow> rows;
  while (table.next())
    rows.push_back({table.text("query_id"), stamp_in(table), pose_in(table), status_named(table),
                    share_in(table, "probability"), share_in(table, "none")});
  return rows;
}

std::vector<AlternativeRow> read_alternatives(const std::string& path) {
  CsvTable table(path, {"query_id", "timestamp", "x", "y", "theta", "probability"});
  std::vector<AlternativeRow> rows;
  while (table.next())
    rows.push_back({table.text("query_id"), stamp_in(table), pose_in(table), share_in(table, "probability")});
  return rows;
}

}  // namespace opal
