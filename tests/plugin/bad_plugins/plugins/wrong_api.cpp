// What the next API's plugins will look like from here.
#include <boost/dll/alias.hpp>

namespace {
const int opal_descriptor_ = 2;
}

BOOST_DLL_ALIAS_SECTIONED(opal_descriptor_, opal_plugin_v2, opal_v2)
