#include "interpreter.hpp"

#include <opal/common/error.hpp>

#include <dlfcn.h>
#include <pthread.h>

#include <filesystem>
#include <mutex>
#include <sstream>

namespace opal::python_classes {

namespace py = pybind11;
namespace fs = std::filesystem;

namespace {

/// Modules written in C, as those of numpy, look for the interpreter among what all libraries see.
void show_interpreter_to_all() {
  Dl_info info{};
  if (dladdr(reinterpret_cast<const void*>(&Py_InitializeFromConfig), &info) != 0 && info.dli_fname != nullptr)
    dlopen(info.dli_fname, RTLD_NOW | RTLD_GLOBAL | RTLD_NOLOAD);
}

void initialize() {
  PyConfig config;
  PyConfig_InitPythonConfig(&config);
  config.install_signal_handlers = 0;  // Ctrl-C is the program's
  config.write_bytecode = 0;           // nothing is left beside the files of others
  PyStatus status = PyConfig_SetBytesString(&config, &config.program_name, OPAL_INTERPRETER);
  if (PyStatus_Exception(status) == 0) status = Py_InitializeFromConfig(&config);
  PyConfig_Clear(&config);
  if (PyStatus_Exception(status) != 0)
    throw PluginError(std::string("Python cannot be started: ") + (status.err_msg ? status.err_msg : "no reason"));
}

/// The package of this build or installation goes first: another one would be of another libopal.so.
void find_package() {
  Dl_info info{};
  dladdr(reinterpret_cast<const void*>(&start_python), &info);
  const fs::path here = fs::weakly_canonical(info.dli_fname).parent_path();
  std::istringstream folders(OPAL_PACKAGE_FOLDERS);
  for (std::string folder; std::getline(folders, folder, ':');)
    if (const fs::path path = here / folder; fs::exists(path / "opal" / "__init__.py")) {
      py::module_::import("sys").attr("path").attr("insert")(0, fs::canonical(path).string());
      return;
    }
}

PyGILState_STATE forking;  // of the thread that forks

/// A child that is forked while another thread is inside Python would wait for that thread for ever.
void make_fork_safe() {
  pthread_atfork(
      [] {
        forking = PyGILState_Ensure();
        PyOS_BeforeFork();
      },
      [] {
        PyOS_AfterFork_Parent();
        PyGILState_Release(forking);
      },
      [] {
        PyOS_AfterFork_Child();
        PyGILState_Release(forking);
      });
}

void start() {
  if (Py_IsInitialized() != 0) return;
  show_interpreter_to_all();
  initialize();
  find_package();
  PyEval_SaveThread();  // every call takes the lock for itself
  make_fork_safe();
}

}  // namespace

void start_python() {
  static std::once_flag once;
  std::call_once(once, start);
}

py::module_ host_module() { return py::module_::import("opal.plugin"); }

}  // namespace opal::python_classes
