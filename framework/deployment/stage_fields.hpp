#pragma once

#include <opal/localization/options/localizer_options.hpp>

#include <variant>
#include <vector>

namespace opal {

/// One option of a stage: where it is kept, and what people are told of it. Defaults are those of the struct.
template <class Stage>
struct StageField {
  const char* name;
  std::variant<int Stage::*, double Stage::*, bool Stage::*> member;
  const char* unit;
  double minimum, maximum;  ///< of a number
  const char* meaning;      ///< sentences that stand alone; name, unit, default and range are printed beside them
};

template <class Stage>
using StageFields = std::vector<StageField<Stage>>;

/// Greatest value of what has no natural limit.
inline constexpr double kUnlimited = 1e6;

// Where hypotheses come from: search_fields.cpp.
const StageFields<SearchScheduleOptions>& fields_of(const SearchScheduleOptions&);
const StageFields<SearchOptions>& fields_of(const SearchOptions&);
const StageFields<VerificationOptions>& fields_of(const VerificationOptions&);

// What becomes of them from scan to scan: hypothesis_fields.cpp.
const StageFields<TemperingOptions>& fields_of(const TemperingOptions&);
const StageFields<GrowthOptions>& fields_of(const GrowthOptions&);
const StageFields<TrackingOptions>& fields_of(const TrackingOptions&);
const StageFields<HypothesesOptions>& fields_of(const HypothesesOptions&);

// What is said of them: decision_fields.cpp.
const StageFields<StatusOptions>& fields_of(const StatusOptions&);
const StageFields<KidnappingOptions>& fields_of(const KidnappingOptions&);
const StageFields<RideOptions>& fields_of(const RideOptions&);

}  // namespace opal
