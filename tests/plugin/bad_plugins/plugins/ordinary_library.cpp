// No plugin at all. If it is ever opened, its constructor leaves a trace.
#include <cstdlib>

namespace {
const int trace = setenv("OPAL_TEST_ORDINARY_LIBRARY_WAS_OPENED", "yes", 1);
}

extern "C" int ordinary_function() { return trace; }
