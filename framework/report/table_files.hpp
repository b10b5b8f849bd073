#pragma once

#include "report/table.hpp"

namespace opal {

/// Writes a table as PATH.csv, PATH.md and PATH.tex. @throws WriteError naming the file.
void write_table(const std::string& path, const Table& table);

}  // namespace opal
