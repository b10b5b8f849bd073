#pragma once

#include "dxf_scan.hpp"

#include <string>

namespace opal::dxf_importer {

/// An entity, and the records that belong to it: the vertices of a polyline.
struct DxfEntityRecords {
  DxfRecord head;
  std::vector<DxfRecord> parts;
};

/// Whether the importer makes something of an entity of this type.
bool is_understood(const std::string& type);

/// All that dxflib would pass over without a word: values that are missing, there twice or no numbers, and numbers of
/// vertices that do not agree with the vertices. For types that are understood.
/// @throws MapError "PATH:LINE: what was found, what was expected".
void check_records(const std::string& path, const DxfEntityRecords& entity);

}  // namespace opal::dxf_importer
