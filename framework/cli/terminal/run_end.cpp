#include "cli/terminal/run_end.hpp"

#include "cli/options/exit_code.hpp"
#include "output/unfinished_run.hpp"

#include <cstdio>
#include <iostream>

namespace opal::cli {

int end_run(OutputFolder& folder, int signal, int exit_code) {
  if (signal == 0) {
    folder.finish();
    return exit_code;
  }
  folder.interrupt(signal);
  std::fflush(stdout);
  std::cerr << "opal: interrupted (" << signal_name(signal) << "): " << folder.path().string()
            << " holds what was finished, and is marked as unfinished (" << kUnfinishedMarker << ")\n";
  return interrupted_by(signal);
}

}  // namespace opal::cli
