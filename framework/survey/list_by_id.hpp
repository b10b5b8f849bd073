#pragma once

#include <vector>

namespace opal {

/// A list of one value for each thing of a kind, in the order of their numbers.
template <class Key, class Value>
class ListById : public std::vector<Value> {
 public:
  using std::vector<Value>::vector;
  Value& operator[](Key id) { return std::vector<Value>::operator[](id.number()); }
  const Value& operator[](Key id) const { return std::vector<Value>::operator[](id.number()); }
};

}  // namespace opal
