#pragma once

#include <opal/localization/scoring/hypothesis.hpp>

#include <vector>

namespace opal {

/// The tree of Algorithm 2 (Hendrikx 2023, 3.4): a node pairs a set of local features with a set of map features, or
/// with nothing on the map; a leaf is a hypothesis. Nodes live in one arena, and those that no leaf needs are reused.
class OPAL_EXPORT AssociationTree {
 public:
  struct Node {
    int parent = -1;
    std::vector<Association> pairs;
    int users = 0;  ///< children, plus one if it is a leaf; 0: free
  };

  /// @return number of the new leaf under `parent` (-1: a root). `parent` stays a leaf until released.
  int add(int parent, std::vector<Association> pairs);
  /// The hypothesis at this leaf is over, or has grown children: forget nodes that nobody needs any more.
  void release(int leaf);
  const Node& node(int number) const { return nodes_[number]; }
  /// Pairs along the branch, root first.
  std::vector<Association> branch(int leaf) const;
  /// Pairs of the first node of a branch: the pattern that it began with.
  const std::vector<Association>& first_pairs(int leaf) const;
  std::size_t size() const { return nodes_.size() - free_.size(); }
  void clear();

 private:
  std::vector<Node> nodes_;
  std::vector<int> free_;
};

}  // namespace opal
