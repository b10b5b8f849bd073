#include "localization/options/association_options.hpp"
#include "localization/tree/association_tree.hpp"
#include <opal/common/error.hpp>

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

TEST_CASE("association options are read by name") {
  const auto options = read_association_options(
      {{"seed_patterns", 4}, {"memory", 0.9}, {"branch_not_on_map", true},
       {"region", {{"x_m", 1.0}, {"y_m", -2}, {"radius_m", 5}}}}, "a.jsonld: /association");
  CHECK(options.seed_patterns == 4);
  CHECK(options.memory == 0.9);
  CHECK(options.branch_not_on_map);
  REQUIRE(options.region);
  CHECK(options.region->center == Point(1, -2));
}

TEST_CASE("a wrong association option is refused with its place, what was found and what is expected") {
  const auto message = [](const nlohmann::json& options) -> std::string {
    try {
      read_association_options(options, "a.jsonld: /association");
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "nothing was refused";
  };
  CHECK(message({{"memmory", 0.9}}) == "a.jsonld: /association/memmory: is no association option");
  CHECK(message({{"memory", 1.5}}) == "a.jsonld: /association/memory: 1.5, expected a number from 0.0 to 1.0");
  CHECK(message({{"max_branches", 1.5}}) ==
        "a.jsonld: /association/max_branches: 1.5, expected an integer from 1.0 to 1000.0");
  CHECK(message({{"branch_not_on_map", 1}}) == "a.jsonld: /association/branch_not_on_map: 1, expected true or false");
  CHECK(message({{"region", {{"x_m", 1}}}}) ==
        "a.jsonld: /association/region: {\"x_m\":1}, expected an object with x_m, y_m and radius_m");
}
