#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace opal::ifc_importer {

/// Without the white space at both ends.
std::string_view trimmed(std::string_view text);

/// One instance of the data section. Views point into StepText::text.
struct StepInstance {
  int number = 0;               ///< of "#12="
  std::string_view type;        ///< "IFCWALL"
  std::string_view arguments;   ///< between the parentheses
  std::string_view global_id;   ///< its first argument, if that is a text; else empty
  std::vector<int> references;  ///< numbers of the instances that it mentions
  std::vector<int> ignored;     ///< of those that it mentions and does without
};

/// A STEP file (ISO 10303-21) as text, looked over before a parser builds objects of it: whole, closed, without
/// references to nothing and without circles, so that what a parser leaves out can be told. Side information that is
/// not so is left out.
class StepText {
 public:
  /// @throws MapError naming the file, the place (line or instance), what was found and what was expected.
  static StepText read(const std::string& path);
  /// @param name  stands for the file in messages.
  static StepText parse(std::string text, const std::string& name);

  const std::string& schema() const { return schema_; }  ///< "IFC2X3", "IFC4", "IFC4X3_ADD2": as the file says
  const std::vector<StepInstance>& instances() const { return instances_; }
  bool is_cut_off() const { return is_cut_off_; }  ///< what comes after its last instance is not known
  const std::vector<std::string>& left_out() const { return left_out_; }  ///< sentences about what was

  /// The same instances, one a line and without comments, in a schema that the parser knows: IFC4X3 as IFC4, with
  /// arguments as they were there; IFC2x and IFC2x2 as IFC2X3, which changed nothing of what is read here.
  std::string for_parser() const;

 private:
  std::string text_;
  std::string schema_;
  std::vector<StepInstance> instances_;
  std::vector<std::string> left_out_;
  bool is_cut_off_ = false;
};

/// Whether a file begins like a STEP file; false if it cannot be read.
bool begins_like_step(const std::string& path);

}  // namespace opal::ifc_importer
