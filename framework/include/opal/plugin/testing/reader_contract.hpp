#pragma once

#include <opal/map/map_importer.hpp>
#include <opal/plugin/registrar.hpp>
#include <opal/sensing/log_source.hpp>

#include <string>
#include <vector>

namespace opal::testing {

/// What every reader of foreign files promises, tried on files that are missing, empty, folders, or noise: it
/// does not recognise them, does not throw while looking, and refuses to open them with the error that its
/// interface names.
/// @return violations, one sentence each; empty for a good citizen.
OPAL_EXPORT std::vector<std::string> log_source_violations(const LogSource& source, const TypeInfo& type);
/// The same for an importer of maps. @return violations, one sentence each; empty for a good citizen.
OPAL_EXPORT std::vector<std::string> map_importer_violations(const MapImporter& importer, const TypeInfo& type);

}  // namespace opal::testing
