#include "localization/tree/association_tree.hpp"

#include <algorithm>

namespace opal {

NodeId AssociationTree::add(NodeId parent, std::vector<Association> pairs) {
  NodeId id(nodes_.size());
  if (free_.empty()) {
    nodes_.emplace_back();
  } else {
    id = free_.back();
    free_.pop_back();
  }
  at(id) = {parent, std::move(pairs), 1};
  if (parent.exists()) ++at(parent).users;
  return id;
}

void AssociationTree::release(NodeId leaf) {
  for (NodeId id = leaf; id.exists();) {
    Node& released = at(id);
    if (--released.users > 0) return;
    const NodeId parent = released.parent;
    released = {};
    free_.push_back(id);
    id = parent;
  }
}

std::vector<Association> AssociationTree::branch(NodeId leaf) const {
  std::vector<Association> pairs;
  for (NodeId id = leaf; id.exists(); id = node(id).parent)
    pairs.insert(pairs.end(), node(id).pairs.rbegin(), node(id).pairs.rend());
  std::reverse(pairs.begin(), pairs.end());
  return pairs;
}

const std::vector<Association>& AssociationTree::first_pairs(NodeId leaf) const {
  NodeId id = leaf;
  while (node(id).parent.exists()) id = node(id).parent;
  return node(id).pairs;
}

void AssociationTree::clear() {
  nodes_.clear();
  free_.clear();
}

}  // namespace opal
