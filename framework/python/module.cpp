#include "python/bindings.hpp"

PYBIND11_MODULE(_opal, module) {
  using namespace opal::python;
  module.doc() =
      "Opal in Python: maps, recorded logs, the localizer step by step, benches. Units are metres, radians and "
      "seconds; "
      "a pose is an array of x [m], y [m] and heading [rad].";
  bind_errors(module);
  bind_plugins(module);
  bind_map(module);
  bind_scan(module);
  bind_deployment(module);
  bind_log(module);
  bind_estimate(module);
  bind_run(module);
  bind_localizer(module);
  bind_bench(module);
  bind_plugin_types(module);
  bind_simulation(module);
  bind_events(module);
}
