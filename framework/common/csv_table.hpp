#pragma once

#include <opal/common/export.hpp>

#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace opal {

/// RFC 4180: quoted where it has to be.
OPAL_EXPORT std::string csv_field(const std::string& text);

/// A CSV file with a header, row by row.
class OPAL_EXPORT CsvTable {
 public:
  /// @throws LogError if it cannot be read, or lacks one of these columns.
  CsvTable(std::string path, const std::vector<std::string>& columns);

  /// Goes to the next row. @return false at the end. @throws LogError if it has too few fields.
  bool next();
  const std::string& text(const std::string& column) const;
  /// @throws LogError if it is no finite number from `minimum` to `maximum`.
  double number(const std::string& column, double minimum, double maximum) const;
  [[noreturn]] void refuse(const std::string& column, const std::string& expected) const;

 private:
  std::string path_;
  std::ifstream file_;
  std::map<std::string, std::size_t> columns_;
  std::vector<std::string> fields_;
  int line_ = 0;
};

}  // namespace opal
