#pragma once

#include <opal/map/semantic_map.hpp>

#include <memory>

namespace opal::python {

/// A map as Python holds it; all of it is read only.
struct MapHandle {
  std::shared_ptr<const SemanticMap> map;
};

}  // namespace opal::python
