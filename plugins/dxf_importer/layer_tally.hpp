#pragma once

#include <map>
#include <string>
#include <vector>

namespace opal::dxf_importer {

/// What was found on the layers of a drawing, and what became of it.
class LayerTally {
 public:
  void count_used(const std::string& layer, const std::string& object_type, const std::string& entity_type);
  /// @param why  begins the sentence: "no class for this layer".
  void count_left_out(const std::string& layer, const std::string& why, const std::string& entity_type, const std::string& id);

  /// What is used first; then what is left out, and why.
  std::vector<std::string> sentences() const;
  std::vector<std::string> layers() const;
  /// "'A-WALL' (120 LINE), ..." of everything, for a message that nothing can be used.
  std::string overview() const;

 private:
  struct Count {
    std::map<std::string, int> by_type;
    std::vector<std::string> ids;  ///< the first ones
  };
  static std::string text_of(const Count& count);

  std::map<std::pair<std::string, std::string>, Count> used_;      ///< by layer and object type
  std::map<std::pair<std::string, std::string>, Count> left_out_;  ///< by reason and layer
};

}  // namespace opal::dxf_importer
