#pragma once

#include <opal/common/export.hpp>

#include <nlohmann/json.hpp>

#include <limits>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace opal {

/// Both ends included.
struct NumberRange {
  double minimum = std::numeric_limits<double>::lowest();
  double maximum = std::numeric_limits<double>::max();
};

/// One object of a configuration document, read strictly: values have the right type and range, and a key that nobody
/// asked for is an error, because it is misspelt or obsolete. The document must outlive it.
class OPAL_EXPORT ConfigObject {
 public:
  /// @param place  JSON pointer of `value`; empty for the whole document. @throws ConfigError if it is no object.
  ConfigObject(const nlohmann::json& value, std::string file, std::string place = "");

  double number(const std::string& key, double fallback, NumberRange range = {});
  int integer(const std::string& key, int fallback, NumberRange range = {});
  bool boolean(const std::string& key, bool fallback);
  std::string text(const std::string& key, const std::string& fallback);
  std::string required_text(const std::string& key);
  /// A text or a list of texts; empty if there is no such key.
  std::vector<std::string> texts(const std::string& key);

  /// The value as it is; null if there is none.
  const nlohmann::json& any(const std::string& key);
  std::optional<ConfigObject> object(const std::string& key);
  /// nullopt if there is no such key: an empty list is something else.
  std::optional<std::vector<ConfigObject>> list(const std::string& key);

  /// The two members that every document of Opal's begins with. "@context" is "urn:opal:v1", or a list of it and
  /// objects that define further prefixes. @throws ConfigError if it is of another type.
  void expect_type(const std::string& type);

  /// @throws ConfigError for the first key that was not asked for, with those that were.
  void expect_no_more() const;

  /// "configs/hall.jsonld: /sensor/beams", for messages.
  std::string where(const std::string& key) const;
  std::string where() const;
  /// Of a key that is absent, one that nobody asked for and that is spelt nearly so is named instead.
  [[noreturn]] void refuse(const std::string& key, const std::string& expected) const;

 private:
  const nlohmann::json* find(const std::string& key);

  const nlohmann::json* value_;
  std::string file_;
  std::string place_;
  std::set<std::string> asked_;
};

/// A path that stands in a document, from where the program runs; an absolute one stays.
OPAL_EXPORT std::string beside(const std::string& document, const std::string& path);

}  // namespace opal
