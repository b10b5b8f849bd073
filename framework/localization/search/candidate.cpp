#include "localization/search/candidate.hpp"

namespace opal {

const char* name_of(Origin origin) {
  switch (origin) {
    case Origin::pattern: return "pattern";
    case Origin::hint: return "hint";
    case Origin::other_storey: return "other_storey";
    case Origin::ride: return "ride";
    case Origin::branch: return "branch";
  }
  return "";
}

}  // namespace opal
