#pragma once

#include <functional>
#include <string>

namespace opal::ifc_importer {

/// Runs something in a child process first, so that what would bring this process down or never end is an error
/// instead: the library behind ifc_model.hpp follows null pointers of damaged models. Whatever `act` throws is no
/// failure of the trial.
/// @param name     stands for the file in messages.
/// @param cpu_s    how long it may take.
/// @throws MapError if the child dies.
void try_in_child(const std::function<void()>& act, const std::string& name, unsigned cpu_s);

}  // namespace opal::ifc_importer
