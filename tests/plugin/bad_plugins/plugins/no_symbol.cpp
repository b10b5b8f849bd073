#include <boost/dll/alias.hpp>

namespace {
const int opal_descriptor_ = 1;
}

BOOST_DLL_ALIAS_SECTIONED(opal_descriptor_, some_other_symbol, opal_v1)
