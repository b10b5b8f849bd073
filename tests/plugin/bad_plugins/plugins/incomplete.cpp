#include <opal/plugin/plugin.hpp>

OPAL_PLUGIN("incomplete", "1.2.3", nullptr)
