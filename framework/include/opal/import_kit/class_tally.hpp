#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace opal {

/// What was found of each class of a source (layers of a drawing, tags of areas), and what became of it.
class ClassTally {
 public:
  /// @param noun  what classes are called: "layer".
  explicit ClassTally(std::string noun) : noun_(std::move(noun)) {}

  /// Counts one thing that came into the map: its class, the type of its object, and what the source calls
  /// its shape.
  void count_used(const std::string& source_class, const std::string& object_type, const std::string& entity_type);
  /// @param source_class  the layer or class of the thing.
  /// @param why           begins the sentence: "no class for its layer".
  /// @param entity_type   what the source calls its shape: "LINE".
  /// @param id            of the thing; a sentence shows the first five.
  void count_left_out(const std::string& source_class, const std::string& why, const std::string& entity_type,
                      const std::string& id);

  /// What is used first; then what is left out, and why.
  std::vector<std::string> sentences() const;
  /// All classes that were counted, each once, in alphabetical order.
  std::vector<std::string> classes() const;
  /// "'A-WALL' (120 LINE), ..." of everything, for a message that nothing can be used.
  std::string overview() const;

 private:
  struct Count {
    std::map<std::string, int> by_type;
    std::vector<std::string> ids;  ///< the first ones
  };
  static std::string text_of(const Count& count);

  std::string noun_;
  std::map<std::pair<std::string, std::string>, Count> used_;      ///< by class and object type
  std::map<std::pair<std::string, std::string>, Count> left_out_;  ///< by reason and class
};

}  // namespace opal
