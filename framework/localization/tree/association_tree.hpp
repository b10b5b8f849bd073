#pragma once

#include <opal/localization/scoring/hypothesis.hpp>

#include <span>
#include <vector>

namespace opal {

using NodeId = Id<struct AssociationNode>;  ///< of a node of the association tree; that of one that is free is reused

/// The tree of Algorithm 2 (Hendrikx 2023, 3.4): a node pairs a set of local features with a set of map features, or
/// with nothing on the map; a leaf is a hypothesis. Nodes live in one arena, and those that no leaf needs are reused.
class OPAL_EXPORT AssociationTree {
 public:
  struct Node {
    NodeId parent = {};  ///< none: a root
    std::vector<Association> pairs;
    int users = 0;  ///< children, plus one if it is a leaf; 0: free
  };

  /// @return the new leaf under `parent` (none: a root). `parent` stays a leaf until released.
  NodeId add(NodeId parent, std::vector<Association> pairs);
  /// The hypothesis at this leaf is over, or has grown children: forget nodes that nobody needs any more.
  void release(NodeId leaf);
  /// Forgets, of the nodes between root and leaf that no other leaf needs, the pairs that are not kept, and nodes that
  /// have none left: a branch is no longer than what its hypothesis knows.
  void trim(NodeId leaf, std::span<const Association> kept);
  const Node& node(NodeId id) const { return nodes_[id.number()]; }
  /// Pairs along the branch, root first.
  std::vector<Association> branch(NodeId leaf) const;
  /// Pairs of the first node of a branch: the pattern that it began with.
  const std::vector<Association>& first_pairs(NodeId leaf) const;
  std::size_t size() const { return nodes_.size() - free_.size(); }
  void clear();

 private:
  Node& at(NodeId id) { return nodes_[id.number()]; }
  void free(NodeId id);

  std::vector<Node> nodes_;
  std::vector<NodeId> free_;
};

}  // namespace opal
