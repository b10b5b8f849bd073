#include "localization/tree/association_tree.hpp"

#include <algorithm>

namespace opal {

int AssociationTree::add(int parent, std::vector<Association> pairs) {
  int number = static_cast<int>(nodes_.size());
  if (free_.empty()) {
    nodes_.emplace_back();
  } else {
    number = free_.back();
    free_.pop_back();
  }
  nodes_[number] = {parent, std::move(pairs), 1};
  if (parent >= 0) ++nodes_[parent].users;
  return number;
}

void AssociationTree::release(int leaf) {
  for (int number = leaf; number >= 0;) {
    Node& node = nodes_[number];
    if (--node.users > 0) return;
    const int parent = node.parent;
    node = {};
    free_.push_back(number);
    number = parent;
  }
}

std::vector<Association> AssociationTree::branch(int leaf) const {
  std::vector<Association> pairs;
  for (int number = leaf; number >= 0; number = nodes_[number].parent)
    pairs.insert(pairs.end(), nodes_[number].pairs.rbegin(), nodes_[number].pairs.rend());
  std::reverse(pairs.begin(), pairs.end());
  return pairs;
}

const std::vector<Association>& AssociationTree::first_pairs(int leaf) const {
  int number = leaf;
  while (nodes_[number].parent >= 0) number = nodes_[number].parent;
  return nodes_[number].pairs;
}

void AssociationTree::clear() {
  nodes_.clear();
  free_.clear();
}

}  // namespace opal
