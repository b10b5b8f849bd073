#pragma once

#include "output/output_folder.hpp"

namespace opal::cli {

/// Ends a run that wrote into a folder.
/// @param signal     that cut it short; 0: it is finished.
/// @param exit_code  of a finished run.
/// @return the program's exit code. Says on stderr if the run was cut short.
int end_run(OutputFolder& folder, int signal, int exit_code);

}  // namespace opal::cli
