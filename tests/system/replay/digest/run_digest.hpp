#pragma once

#include <nlohmann/json.hpp>

#include <map>
#include <string>
#include <vector>

/// What was said over a whole run, field by field, in a file that is short enough for the tree. Of a field's numbers
/// it has how many they are, their sum, and the sum in which each counts by its place in the row: values that change
/// places are noticed, too. Texts that differ in their numbers only are one field.
class RunDigest {
 public:
  /// Of the sum of amounts. What compilers and processors round otherwise changed the drives by a tenth of it.
  static constexpr double kRoundingOfDrives = 1e-4;

  /// @param rounding  by which a sum may differ, of the sum of amounts.
  explicit RunDigest(double rounding = kRoundingOfDrives) : rounding_(rounding) {}

  /// @param field  names what the value is: "estimate", of which "estimate.none" is a part.
  void take(const std::string& field, const nlohmann::ordered_json& value);
  /// By field: [how many, sum, sum by place].
  nlohmann::ordered_json json() const;
  /// One line for each field that is not as it was, by name; none: all are.
  std::vector<std::string> differences_from(const nlohmann::ordered_json& golden) const;

 private:
  struct Sums {
    long count = 0;
    double sum = 0, by_place = 0;
    double size = 0;  ///< sum of amounts: what rounding is relative to
  };
  void add(const std::string& field, double number);
  void add_text(const std::string& field, const std::string& text);

  bool are_alike(double found, double golden, double size, bool is_text) const;

  double rounding_;
  std::map<std::string, Sums> fields_;
};
