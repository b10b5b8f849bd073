#include "localization/tree/association_tree.hpp"

#include <catch2/catch.hpp>

using namespace opal;

TEST_CASE("a branch of the association tree lists its pairs from the root") {
  AssociationTree tree;
  const int root = tree.add(-1, {{1, 10}, {2, 11}});
  const int child = tree.add(root, {{3, -1}});
  const auto branch = tree.branch(child);
  REQUIRE(branch.size() == 3);
  CHECK(branch[0].local_feature == 1);
  CHECK(branch[1].map_feature == 11);
  CHECK(branch[2].map_feature == -1);
}

TEST_CASE("the tree forgets nodes that no leaf needs, and only those") {
  AssociationTree tree;
  const int root = tree.add(-1, {{1, 10}});
  const int left = tree.add(root, {{2, 20}});
  const int right = tree.add(root, {{2, 21}});
  tree.release(root);  // it has grown children
  CHECK(tree.size() == 3);
  tree.release(left);
  CHECK(tree.size() == 2);
  CHECK(tree.branch(right).size() == 2);
  tree.release(right);
  CHECK(tree.size() == 0);
}
