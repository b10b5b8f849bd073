#pragma once

#include <opal/plugin/registrar.hpp>

namespace opal {

/// What a made object says of itself where its type cannot: the type runs classes that others write. An object
/// implements it beside the interface of its kind.
class OPAL_EXPORT SelfDescribing {
 public:
  virtual ~SelfDescribing();

  /// Its name, and the feature types that it works on. It is the same at every call.
  virtual TypeInfo type_info() const = 0;
};

}  // namespace opal
