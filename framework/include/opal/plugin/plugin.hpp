/// @file
/// What a plugin's plugin.cpp includes: the macro OPAL_PLUGIN, and what it leaves in the library.
#pragma once

#include <opal/plugin/registrar.hpp>

#include <Eigen/Core>
#include <boost/dll/alias.hpp>

#include <cstdint>

namespace opal {

#define OPAL_DETAIL_TEXT_(x) #x
#define OPAL_DETAIL_TEXT(x) OPAL_DETAIL_TEXT_(x)
#ifdef _GLIBCXX_DEBUG
#define OPAL_DETAIL_DEBUG_STL "1"
#else
#define OPAL_DETAIL_DEBUG_STL "0"
#endif

/// Everything that changes the layout of what crosses between framework and plugin. Compared before any
/// plugin function is called.
inline constexpr const char* kAbiTag =
    "api=19 gxx_abi=" OPAL_DETAIL_TEXT(__GXX_ABI_VERSION) " cxx11_abi=" OPAL_DETAIL_TEXT(
        _GLIBCXX_USE_CXX11_ABI) " debug_stl=" OPAL_DETAIL_DEBUG_STL
                                " eigen=" OPAL_DETAIL_TEXT(EIGEN_WORLD_VERSION) "." OPAL_DETAIL_TEXT(
                                    EIGEN_MAJOR_VERSION) "." OPAL_DETAIL_TEXT(EIGEN_MINOR_VERSION);

/// The one symbol of a plugin: plain data and one function.
struct PluginDescriptor {
  const char* abi_tag;            ///< kAbiTag of the headers that the plugin was built with
  std::uint32_t eigen_max_align;  ///< EIGEN_MAX_ALIGN_BYTES of that build
  const char* name;               ///< as plugin.jsonld says
  const char* version;            ///< as plugin.jsonld says
  /// Adds all types that plugin.jsonld describes, and no others.
  void (*register_types)(Registrar&);
};

}  // namespace opal

/// At the end of a plugin's plugin.cpp: its name, its version, and the function that registers its types.
#define OPAL_PLUGIN(NAME, VERSION, REGISTER)                                                                        \
  namespace {                                                                                                       \
  const ::opal::PluginDescriptor opal_descriptor_{::opal::kAbiTag, EIGEN_MAX_ALIGN_BYTES, NAME, VERSION, REGISTER}; \
  }                                                                                                                 \
  BOOST_DLL_ALIAS_SECTIONED(opal_descriptor_, opal_plugin_v1, opal_v1)
