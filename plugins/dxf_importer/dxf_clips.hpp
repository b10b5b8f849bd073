#pragma once

#include "dxf_scan.hpp"

#include <map>
#include <string>
#include <vector>

namespace opal::dxf_importer {

/// Finds the clips (SPATIAL_FILTER, XCLIP) among the objects of a drawing, and to which INSERTs they belong: each
/// object names its owner, the filter a dictionary, this one another, and that one the INSERT.
class DxfClips {
 public:
  /// The next pair of the section OBJECTS.
  void take(const DxfPair& pair);

  int count() const { return static_cast<int>(filters_.size()); }  ///< of clips that are on
  /// Handles of what is clipped, in order; fewer than clips where owners are missing.
  std::vector<std::string> owners() const;

 private:
  struct Object {
    std::string type, handle, owner;
    bool is_before_subclass = true;  ///< later references are no owners
  };

  Object object_;
  std::map<std::string, std::string> owner_of_;  ///< of dictionaries, by handle
  std::vector<std::string> filters_;             ///< owners of those that are on
};

}  // namespace opal::dxf_importer
