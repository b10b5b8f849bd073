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
    free(id);
    id = parent;
  }
}

void AssociationTree::free(NodeId id) {
  at(id) = {};
  free_.push_back(id);
}

void AssociationTree::trim(NodeId leaf, std::span<const Association> kept) {
  const auto is_forgotten = [kept](const Association& pair) {
    return std::none_of(kept.begin(), kept.end(),
                        [&](const Association& other) { return other.local_feature == pair.local_feature; });
  };
  for (NodeId id = leaf; node(id).parent.exists();) {
    const NodeId above = node(id).parent;
    Node& inner = at(above);
    if (!inner.parent.exists() || inner.users > 1) return;
    std::erase_if(inner.pairs, is_forgotten);
    if (inner.pairs.empty()) {
      at(id).parent = inner.parent;
      free(above);
    } else {
      id = above;
    }
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
