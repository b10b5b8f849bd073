#pragma once

#include <memory>
#include <string>

namespace opal {

/// A replaceable part with its name, so that errors, counts and scores can name it.
template <class T>
struct Named {
  std::string name;               ///< by which people and records know it
  std::shared_ptr<const T> part;  ///< the part itself
};

}  // namespace opal
