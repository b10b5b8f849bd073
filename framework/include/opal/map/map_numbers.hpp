#pragma once

#include <opal/common/id.hpp>

namespace opal {

struct MapFeature;
struct MapObject;

using MapFeatureNumber = Id<MapFeature>;  ///< position in SemanticMap::features()
using MapObjectNumber = Id<MapObject>;    ///< position in SemanticMap::objects()

}  // namespace opal
