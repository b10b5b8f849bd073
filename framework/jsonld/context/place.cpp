#include "jsonld/context/place.hpp"

#include <opal/common/strict_json.hpp>
#include "jsonld/json_ld.hpp"

namespace opal::json_ld {
namespace {

// Each level costs a few stack frames: this many fit several times into the 8 MiB of a thread even with
// AddressSanitizer. It leaves room for contexts from the table below the 128 levels that parse_json accepts.
constexpr int kMaxDepth = 256;

}  // namespace

Place::Place(std::string_view document, const Place* from) : key_(document), depth_(from ? from->depth_ + 1 : 0) {
  if (depth_ > kMaxDepth)
    throw JsonLdError("nested too deeply", from->pointer(),
                      "expected at most " + std::to_string(kMaxDepth) + " levels");
}

Place::Place(const Place* parent, Step step, std::string_view key, std::size_t index)
    : parent_(parent), step_(step), key_(key), index_(index), depth_(parent->depth_ + 1) {
  if (depth_ > kMaxDepth)
    throw JsonLdError("nested too deeply", pointer(), "expected at most " + std::to_string(kMaxDepth) + " levels");
}

Place Place::at(std::string_view key) const { return Place(this, Step::kKey, key, 0); }
Place Place::at(std::size_t index) const { return Place(this, Step::kIndex, {}, index); }

std::string Place::pointer() const {
  if (step_ == Step::kRoot) return std::string(key_);
  std::string result = parent_->pointer();
  result += '/';
  result += step_ == Step::kKey ? escape_pointer_step(std::string(key_)) : std::to_string(index_);
  return result;
}

}  // namespace opal::json_ld
