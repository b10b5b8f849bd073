#pragma once

#include "navigation/blackboard.hpp"

#include <memory>
#include <vector>

namespace opal::navigation {

enum class NodeStatus { running, success, failure };

/// A node of a behaviour tree (Colledanchise and Ögren 2018). It is ticked until it has succeeded or failed; then the
/// next tick begins anew.
class Node {
 public:
  virtual ~Node() = default;
  virtual NodeStatus tick(Blackboard& blackboard) = 0;
  /// Gives up what is running: the next tick begins anew. Nothing happens if nothing is running.
  virtual void halt() {}
};

using Children = std::vector<std::unique_ptr<Node>>;

}  // namespace opal::navigation
