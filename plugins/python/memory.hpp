#pragma once

#include <opal/localization/scoring/scorer_memory.hpp>

#include <pybind11/pybind11.h>

#include <memory>

namespace opal::python_classes {

/// What a class of Python remembers of a hypothesis: any object, which is copied by copy.deepcopy. It may be held and
/// given up without the lock of Python; all else needs it.
class PythonMemory final : public ScorerMemory {
 public:
  /// With the lock.
  explicit PythonMemory(pybind11::object state);
  std::unique_ptr<ScorerMemory> copy() const override;

  const pybind11::object& state() const { return *state_; }
  void replace(pybind11::object state);

 private:
  std::shared_ptr<pybind11::object> state_;
};

/// Of a memory that this plugin made. With the lock.
const pybind11::object& state_of(const ScorerMemory& memory);
/// A method has changed a memory: what it returns takes its place, None leaves it. With the lock.
void change(ScorerMemory& memory, pybind11::object returned);

}  // namespace opal::python_classes
