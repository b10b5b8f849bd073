#pragma once

#include <opal/common/id.hpp>

namespace opal {

struct Keyframe;
struct LocalFeature;

using KeyframeId = Id<Keyframe>;          ///< in order of time; never reused
using LocalFeatureId = Id<LocalFeature>;  ///< in order of first sight; never reused
/// One of the squares of 1 m that the local frame is divided into.
using EvidenceCell = Id<struct SquareOfEvidence>;

}  // namespace opal
