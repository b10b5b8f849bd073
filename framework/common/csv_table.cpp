#include "common/csv_table.hpp"

#include <opal/common/error.hpp>
#include <opal/common/number_text.hpp>

namespace opal {
namespace {

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (std::size_t k = 0; k < line.size(); ++k) {
    const char c = line[k];
    if (c == '"' && quoted && k + 1 < line.size() && line[k + 1] == '"')
      fields.back() += line[++k];
    else if (c == '"')
      quoted = !quoted;
    else if (c == ',' && !quoted)
      fields.emplace_back();
    else if (c != '\r')
      fields.back() += c;
  }
  return fields;
}

}  // namespace

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted.append(c == '"' ? 2 : 1, c);
  return quoted + "\"";
}

CsvTable::CsvTable(std::string path, const std::vector<std::string>& columns) : path_(std::move(path)), file_(path_) {
  std::string header;
  if (!file_ || !std::getline(file_, header)) throw LogError(path_ + ": cannot be read, or is empty");
  ++line_;
  const std::vector<std::string> names = split(header);
  for (std::size_t k = 0; k < names.size(); ++k)
    if (!columns_.emplace(names[k], k).second)
      throw LogError(path_ + ": line 1: the column '" + names[k] + "' twice, expected it once");
  for (const std::string& column : columns)
    if (!columns_.contains(column))
      throw LogError(path_ + ": line 1: '" + header + "', expected a column '" + column + "'");
}

bool CsvTable::next() {
  for (std::string line; std::getline(file_, line);) {
    ++line_;
    if (line.empty() || line.front() == '#') continue;
    fields_ = split(line);
    if (fields_.size() < columns_.size())
      throw LogError(path_ + ": line " + std::to_string(line_) + ": " + std::to_string(fields_.size()) +
                     " fields, expected " + std::to_string(columns_.size()));
    return true;
  }
  return false;
}

const std::string& CsvTable::text(const std::string& column) const { return fields_[columns_.at(column)]; }

double CsvTable::number(const std::string& column, double minimum, double maximum) const {
  const auto value = parse_number<double>(text(column));
  if (!value || !(*value >= minimum && *value <= maximum))
    refuse(column, "a number from " + std::to_string(minimum) + " to " + std::to_string(maximum));
  return *value;
}

void CsvTable::refuse(const std::string& column, const std::string& expected) const {
  throw LogError(path_ + ": line " + std::to_string(line_) + ": " + column + ": '" + text(column) + "', expected " +
                 expected);
}

}  // namespace opal
