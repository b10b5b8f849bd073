#pragma once

#include "benchmark/runs/run_record.hpp"
#include "python/values/arrays.hpp"

#include <pybind11/pybind11.h>

namespace opal::python {

/// Ends a replay when somebody has pressed Ctrl-C: asked before every scan, looks at it now and then.
/// @throws pybind11::error_already_set (KeyboardInterrupt).
class Interruptible {
 public:
  bool operator()(double /*stamp_s*/) {
    constexpr int kScans = 64;  // some tenths of a second
    if (++scans_ % kScans != 0) return true;
    const pybind11::gil_scoped_acquire python;
    if (PyErr_CheckSignals() != 0) throw pybind11::error_already_set();
    return true;
  }

 private:
  int scans_ = 0;
};

/// A pandas.DataFrame; pandas is imported here and nowhere else.
pybind11::object data_frame(const pybind11::object& columns);

}  // namespace opal::python
