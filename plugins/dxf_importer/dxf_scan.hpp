#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace opal::dxf_importer {

/// A pair of lines of a DXF file: what a value is, and the value.
struct DxfPair {
  int code = 0;
  std::string value;  ///< without spaces around it
  int line = 0;       ///< of the value, from 1

  double real() const;  ///< 0 if it is no number
};

/// Everything from one code 0 to the next one: an entity, the begin of a block.
struct DxfRecord {
  std::string type;
  int line = 0;  ///< of its type
  std::vector<DxfPair> pairs;

  /// Of the first pair with a code; nothing if there is none.
  const DxfPair* find(int code) const;
  std::string text(int code, const std::string& otherwise = "") const;
  double real(int code, double otherwise) const;
};

struct DxfLayer {
  bool is_frozen = false;
  bool is_off = false;
};

/// A DXF file as records. Nothing in it has been understood yet, but it is whole: every section and block is closed,
/// and the record EOF is there, or the file ends after a section.
struct DxfScan {
  std::optional<int> insunits;  ///< header variable $INSUNITS
  std::map<std::string, DxfLayer> layers;
  std::vector<DxfRecord> blocks;     ///< of the section BLOCKS: BLOCK, entities, ENDBLK, ...
  std::vector<DxfRecord> entities;   ///< of the section ENTITIES
  int clips = 0;                     ///< by which parts of blocks are shown (XCLIP)
  std::vector<std::string> clipped;  ///< handles of the INSERTs that these belong to, as far as they are known
  bool lacks_end = false;            ///< the record EOF is missing, and the section ENTITIES is whole
  int lines_after_end = 0;           ///< lines after EOF, where the drawing ends: nobody reads them
};

/// @throws MapError "PATH:LINE: what was found, what was expected".
DxfScan scan_dxf(const std::string& path);

}  // namespace opal::dxf_importer
