#include "report/table_files.hpp"

#include "common/text_file.hpp"

namespace opal {

void write_table(const std::string& path, const Table& table) {
  write_text(path + ".csv", csv_of(table));
  write_text(path + ".md", markdown_of(table));
  write_text(path + ".tex", latex_of(table));
}

}  // namespace opal
