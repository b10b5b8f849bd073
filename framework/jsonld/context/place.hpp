#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace opal::json_ld {

/// Where something stands in a source document: a chain of keys and indices that lives on the stack beside
/// the recursion it describes. Its text is made only when an error or a kept pointer asks for it.
class Place {
 public:
  /// The top of a document. @param document  "" for the main one; else what its pointers start with, e.g.
  /// "urn:opal:v1#". @param from  the place that led here, whose depth counts on.
  explicit Place(std::string_view document = {}, const Place* from = nullptr);

  /// @throws JsonLdError when nested too deeply, which bounds every recursion of this processor.
  /// The key must outlive the place.
  Place at(std::string_view key) const;
  Place at(std::size_t index) const;

  /// JSON pointer (RFC 6901); after the document's prefix if it has one.
  std::string pointer() const;

 private:
  enum class Step { kRoot, kKey, kIndex };
  Place(const Place* parent, Step step, std::string_view key, std::size_t index);

  const Place* parent_ = nullptr;
  Step step_ = Step::kRoot;
  std::string_view key_;
  std::size_t index_ = 0;
  int depth_ = 0;
};

}  // namespace opal::json_ld
