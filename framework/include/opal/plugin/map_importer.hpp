#pragma once

#include <opal/semantic_map.hpp>

#include <memory>
#include <string>
#include <vector>

namespace opal {

/// What an importer made of a source, and what it left out.
struct MapImport {
  std::shared_ptr<const SemanticMap> map;
  /// Sentences for the person who runs the import, in reading order ("1204 wall faces, 1830 m", "left out: ...").
  std::vector<std::string> report;
};

/// Makes a semantic map of one kind of source (a grid, a building model).
class OPAL_EXPORT MapImporter {
 public:
  virtual ~MapImporter();
  /// True if the file looks like this importer's kind (by name and first bytes); must not throw.
  virtual bool recognizes(const std::string& path) const = 0;
  /// @throws MapError naming the file and the place in it.
  virtual MapImport import(const std::string& path) const = 0;
};

}  // namespace opal
