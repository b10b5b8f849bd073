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
