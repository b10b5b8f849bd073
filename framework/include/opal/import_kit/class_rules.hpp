#pragma once

#include <nlohmann/json.hpp>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace opal {

/// Says what the layers or classes of a source become: names, with `*` for any characters and `?` for one, to object
/// types. Upper and lower case are the same. If several rules fit a name, the one with the most characters of its own
/// goes first.
class ClassRules {
 public:
  /// What a rule says of names that shall not come into the map.
  static constexpr const char* kLeaveOut = "leave_out";

  /// @param given     an importer's option `classes`: {"A-WALL*": "opal:Wall", "A-FURN*": "leave_out"}. These rules go
  /// before
  ///                  all defaults; "Wall" stands for "opal:Wall".
  /// @param defaults  in the same form.
  ClassRules(const nlohmann::json& given, const std::map<std::string, std::string>& defaults);

  /// An object type, kLeaveOut, or nothing if no rule fits.
  std::optional<std::string> class_of(const std::string& name) const {
    return class_of(std::vector<std::string>{name});
  }
  /// Of a thing with several names: by the first rule that fits any of them.
  std::optional<std::string> class_of(const std::vector<std::string>& names) const;
  /// Given rules that fit none of these names: misspelt, perhaps.
  std::vector<std::string> unused(const std::vector<std::string>& names) const;

 private:
  struct Rule {
    std::string pattern;
    std::string compared;  ///< in upper case, also beyond ASCII
    std::string type;
    bool is_given = false;
  };
  const Rule* rule_for(const std::vector<std::string>& names) const;

  std::vector<Rule> rules_;  ///< the first that fits decides
};

/// Whether a name fits a pattern with `*` and `?`, in upper or lower case of ASCII letters. Time grows with the product
/// of the lengths at most.
bool fits_pattern(const std::string& name, const std::string& pattern);

}  // namespace opal
