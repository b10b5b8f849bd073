#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <type_traits>
#include <vector>

namespace opal {

/// Values side by side that do not change: in memory, or in a file that is mapped into it.
template <class T>
requires std::is_trivially_copyable_v<T>
class ReadOnlyArray {
 public:
  ReadOnlyArray() = default;
  explicit ReadOnlyArray(std::vector<T> values)
      : owner_(std::make_shared<const std::vector<T>>(std::move(values))),
        values_(*static_cast<const std::vector<T>*>(owner_.get())) {}
  /// @param owner  of the memory that the values lie in.
  ReadOnlyArray(std::shared_ptr<const void> owner, std::span<const T> values)
      : owner_(std::move(owner)), values_(values) {}

  const T& operator[](std::size_t k) const { return values_[k]; }
  std::size_t size() const { return values_.size(); }
  std::span<const T> values() const { return values_; }

 private:
  std::shared_ptr<const void> owner_;
  std::span<const T> values_;
};

}  // namespace opal
