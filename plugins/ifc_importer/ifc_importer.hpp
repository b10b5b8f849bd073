#pragma once

#include "import_options.hpp"

#include <opal/map/map_importer.hpp>

namespace opal::ifc_importer {

/// Cuts a building model at a sensor's height. README.md tells the steps.
class IfcImporter : public MapImporter {
 public:
  /// @throws MapError if an option makes no sense.
  explicit IfcImporter(ImportOptions options);
  bool recognizes(const std::string& path) const override;
  MapImport import(const std::string& path) const override;
  std::vector<Storey> storeys(const std::string& path) const override;

 private:
  ImportOptions options_;
};

}  // namespace opal::ifc_importer
