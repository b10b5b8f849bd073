#include "synthetic.hpp"

#include "navigation/control_nodes.hpp"
#include "navigation/node_registry.hpp"

#include <opal/common/error.hpp>
#include <opal/common/strict_json.hpp>
#include "jsonld/json_ld.hpp"
#include "tests/kit/refusal.hpp"

#include <catch2/catch.hpp>

using namespace opal;
using namespace opal::navigation;
using Memory = ControlFlow::Memory;

namespace {

constexpr NodeStatus running = NodeStatus::running, success = NodeStatus::success, failure = NodeStatus::failure;

/// Comes out as scripted, the last way again and again; counts.
struct Scripted : Node {
  explicit Scripted(std::vector<NodeStatus> outcomes) : script(std::move(outcomes)) {}
  NodeStatus tick(Blackboard&) override {
    const NodeStatus outcome = script[std::min<std::size_t>(ticks, script.size() - 1)];
    ++ticks;
    return outcome;
  }
  void halt() override { ++halts; }
  std::vector<NodeStatus> script;
  std::size_t ticks = 0;
  int halts = 0;
};

/// A succession of scripted nodes, which stay at hand.
struct Made {
  Made(NodeStatus go_on, Memory memory, std::vector<std::vector<NodeStatus>> scripts) {
    Children children;
    for (auto& script : scripts) {
      auto node = std::make_unique<Scripted>(std::move(script));
      nodes.push_back(node.get());
      children.push_back(std::move(node));
    }
    root = std::make_unique<ControlFlow>(go_on, memory, std::move(children));
  }
  NodeStatus tick() { return root->tick(moment.blackboard); }
  SyntheticMoment moment;
  std::vector<Scripted*> nodes;
  std::unique_ptr<Node> root;
};

std::string refusal(const std::string& root) {
  return refused_with<ConfigError>([&] {
    parse_tree(standard_nodes(),
               R"({"@context": "urn:opal:v1", "@type": "opal:BehaviourTrees", "trees": [{"name": "a", "root": )" +
                   root + "}]}",
               "t.jsonld");
  });
}

}  // namespace

TEST_CASE("a sequence goes on where it was, and ends with the first failure") {
  Made made(success, Memory::keeps_place, {{success}, {running, success}, {failure}});
  CHECK(made.tick() == running);
  CHECK(made.tick() == failure);
  CHECK(made.nodes[0]->ticks == 1);
  CHECK(made.nodes[1]->ticks == 2);
  CHECK(made.tick() == failure);  // anew
  CHECK(made.nodes[0]->ticks == 2);
}

TEST_CASE("a reactive sequence asks its conditions again, and halts what they no longer allow") {
  Made made(success, Memory::starts_over, {{success, failure}, {running}});
  CHECK(made.tick() == running);
  CHECK(made.nodes[1]->halts == 0);
  CHECK(made.tick() == failure);
  CHECK(made.nodes[1]->halts == 1);
}

TEST_CASE("a fallback tries one after the other until one does not fail") {
  Made made(failure, Memory::keeps_place, {{failure}, {running, success}, {success}});
  CHECK(made.tick() == running);
  CHECK(made.tick() == success);
  CHECK(made.nodes[0]->ticks == 1);
  CHECK(made.nodes[2]->ticks == 0);
}

TEST_CASE("a reactive fallback lets an earlier child take over from a running one") {
  Made made(failure, Memory::starts_over, {{failure, running}, {running}});
  CHECK(made.tick() == running);
  CHECK(made.tick() == running);
  CHECK(made.nodes[1]->ticks == 1);
  CHECK(made.nodes[1]->halts == 1);
}

TEST_CASE("all fail, all succeed, and a halted sequence begins anew") {
  CHECK(Made(failure, Memory::keeps_place, {{failure}, {failure}}).tick() == failure);
  CHECK(Made(success, Memory::keeps_place, {{success}, {success}}).tick() == success);
  Made made(success, Memory::keeps_place, {{success}, {running}});
  made.tick();
  made.root->halt();
  made.tick();
  CHECK(made.nodes[0]->ticks == 2);
}

TEST_CASE("decorators") {
  SyntheticMoment moment;
  const auto scripted = [](NodeStatus outcome) { return std::make_unique<Scripted>(std::vector<NodeStatus>{outcome}); };
  CHECK(Inverter(scripted(success)).tick(moment.blackboard) == failure);
  CHECK(Inverter(scripted(failure)).tick(moment.blackboard) == success);
  CHECK(Inverter(scripted(running)).tick(moment.blackboard) == running);
  CHECK(Forced(failure, scripted(success)).tick(moment.blackboard) == failure);
  CHECK(Forced(failure, scripted(running)).tick(moment.blackboard) == running);
  auto child = scripted(success);
  const Scripted& seen = *child;
  Once once(std::move(child));
  CHECK(once.tick(moment.blackboard) == success);
  CHECK(once.tick(moment.blackboard) == success);
  CHECK(seen.ticks == 1);
}

TEST_CASE("a document is read strictly") {
  using Catch::Contains;
  CHECK(refusal(R"({"@type": "opal:Rotate"})") == "accepted");
  CHECK_THAT(refusal(R"({"@type": "opal:Fly"})"),
             Contains("t.jsonld: /trees/0/root/@type: \"opal:Fly\", expected one of: opal:BackOff"));
  CHECK_THAT(refusal(R"({"@type": "opal:Sequence"})"), Contains("/trees/0/root/children: absent, expected a list"));
  CHECK_THAT(refusal(R"({"@type": "opal:Inverter", "children": [{"@type": "opal:Rotate"}, {"@type": "opal:Rotate"}]})"),
             Contains("/trees/0/root/children") && Contains("a list of one node"));
  CHECK_THAT(refusal(R"({"@type": "opal:Rotate", "children": [{"@type": "opal:Rotate"}]})"),
             Contains("/trees/0/root/children: unknown key"));
  CHECK_THAT(refusal(R"({"@type": "opal:Rotate", "options": {"turn": 1}})"),
             Contains("/trees/0/root/options/turn: unknown key"));
  CHECK_THAT(
      refusal(R"({"@type": "opal:Sequence", "children": [{"@type": "opal:Rotate", "options": {"turns": 1000}}]})"),
      Contains("/trees/0/root/children/0/options/turns: 1000, expected a number from -10 to 10"));
  CHECK_THROWS_WITH(read_tree(standard_nodes(), OPAL_SOURCE_DIR "/configs/behaviours.jsonld", "dance"),
                    Contains("no tree is called 'dance', expected one of: disambiguate"));
}

TEST_CASE("every shipped tree can be made, and the document is JSON-LD of Opal's vocabulary, its lists ordered") {
  const std::string path = OPAL_SOURCE_DIR "/configs/behaviours.jsonld";
  for (const char* name : {"disambiguate", "rotate_and_go", "inspect", "search"})
    CHECK(read_tree(standard_nodes(), path, name));
  json_ld::Options options;
  options.contexts["urn:opal:v1"] = read_json(OPAL_SOURCE_DIR "/maps/context/opal.jsonld");
  options.reject_unknown_terms = true;
  const nlohmann::json expanded = json_ld::expand(read_json(path), options);
  REQUIRE(expanded.size() == 1);
  const nlohmann::json& root = expanded[0]["urn:opal:v1#trees"][0]["@list"][0]["urn:opal:v1#root"][0];
  CHECK(root["urn:opal:v1#children"][0].contains("@list"));
}

TEST_CASE("something can be put around the nodes of a type, and the first tree has a name") {
  NodeRegistry nodes = standard_nodes();
  int made = 0;
  nodes.wrap("opal:Rotate", [&](std::unique_ptr<Node> node) {
    ++made;
    return node;
  });
  parse_tree(nodes, R"({"@context": "urn:opal:v1", "@type": "opal:BehaviourTrees", "trees": [{"name": "a", "root":
    {"@type": "opal:Sequence", "children": [{"@type": "opal:Rotate"}, {"@type": "opal:Rotate"}, {"@type": "opal:BackOff"}]}}]})",
             "t.jsonld");
  CHECK(made == 2);
  CHECK_THROWS_WITH(nodes.wrap("opal:Fly", nullptr), Catch::Contains("opal:Fly") && Catch::Contains("opal:Rotate"));
  CHECK(first_tree(OPAL_SOURCE_DIR "/configs/behaviours.jsonld") == "disambiguate");
}
