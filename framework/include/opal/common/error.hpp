#pragma once

#include <opal/common/export.hpp>

#include <stdexcept>
#include <string>

namespace opal {

/// Wrong input at start-up. The message says what was being done, to which file and place in it, what was
/// found, and what was expected: "configs/a.jsonld: /detectors/0/options/min_points: 1, expected an integer >= 2".
/// A poor scan is never an Error: it is a status (see localizer.hpp).
class OPAL_EXPORT Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
  ~Error() override;
};

/// A deployment, sensor or query document is unusable.
class OPAL_EXPORT ConfigError : public Error {
 public:
  using Error::Error;
  ~ConfigError() override;
};

/// A map document, or a source that a map is imported from, is unusable.
class OPAL_EXPORT MapError : public Error {
 public:
  using Error::Error;
  ~MapError() override;
};

/// A recorded log is unusable as a whole. Damaged records inside a log are counted instead.
class OPAL_EXPORT LogError : public Error {
 public:
  using Error::Error;
  ~LogError() override;
};

/// An event stream (docs/events.md) is unusable from some event on.
class OPAL_EXPORT EventError : public Error {
 public:
  using Error::Error;
  ~EventError() override;
};

/// A plugin was refused, or failed when called. The message names the file or the type and the cause.
class OPAL_EXPORT PluginError : public Error {
 public:
  using Error::Error;
  ~PluginError() override;
};

}  // namespace opal
