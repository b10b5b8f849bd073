#include "localization/tree/association_tree.hpp"

#include <catch2/catch.hpp>

using namespace opal;

namespace {

Association pair(int local_feature, int map_feature) {
  return {LocalFeatureId(local_feature), MapFeatureNumber(map_feature)};
}

}  // namespace

TEST_CASE("a branch of the association tree lists its pairs from the root") {
  AssociationTree tree;
  const NodeId root = tree.add({}, {pair(1, 10), pair(2, 11)});
  const NodeId child = tree.add(root, {pair(3, -1)});
  const auto branch = tree.branch(child);
  REQUIRE(branch.size() == 3);
  CHECK(branch[0].local_feature == LocalFeatureId(1));
  CHECK(branch[1].map_feature == MapFeatureNumber(11));
  CHECK_FALSE(branch[2].map_feature.exists());
}

TEST_CASE("the tree forgets nodes that no leaf needs, and only those") {
  AssociationTree tree;
  const NodeId root = tree.add({}, {pair(1, 10)});
  const NodeId left = tree.add(root, {pair(2, 20)});
  const NodeId right = tree.add(root, {pair(2, 21)});
  tree.release(root);  // it has grown children
  CHECK(tree.size() == 3);
  tree.release(left);
  CHECK(tree.size() == 2);
  CHECK(tree.branch(right).size() == 2);
  tree.release(right);
  CHECK(tree.size() == 0);
}

TEST_CASE("a branch that is trimmed keeps its root, its leaf and what is kept, and the tree does not grow") {
  AssociationTree tree;
  NodeId leaf = tree.add({}, {pair(0, 10)});
  for (int k = 1; k <= 1000; ++k) {
    const NodeId next = tree.add(leaf, {pair(k, 10)});
    tree.release(leaf);
    leaf = next;
    tree.trim(leaf, std::vector{pair(k - 1, 10), pair(k, 10)});
    CHECK(tree.size() <= 3);
  }
  const auto branch = tree.branch(leaf);
  REQUIRE(branch.size() == 3);
  CHECK(branch[0].local_feature == LocalFeatureId(0));
  CHECK(branch[1].local_feature == LocalFeatureId(999));
  tree.release(leaf);
  CHECK(tree.size() == 0);
}

TEST_CASE("what other leaves need is not trimmed") {
  AssociationTree tree;
  const NodeId root = tree.add({}, {pair(0, 10)}), shared = tree.add(root, {pair(1, 10)});
  tree.release(root);
  const NodeId left = tree.add(shared, {pair(2, 20)}), right = tree.add(shared, {pair(2, 21)});
  tree.release(shared);
  tree.trim(left, {});
  CHECK(tree.branch(right).size() == 3);
  CHECK(tree.branch(left).size() == 3);
}
