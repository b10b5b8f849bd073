// The key functions of the interfaces: one vtable and one typeinfo each.
#include <opal/recording/recording.hpp>

namespace opal::recording {

MessageWalk::~MessageWalk() = default;
Recording::~Recording() = default;

}  // namespace opal::recording
