#include "session/moved_deployment.hpp"

#include <catch2/catch.hpp>

using namespace opal;
using nlohmann::ordered_json;

namespace {

const ordered_json kDocument = {
    {"map", "hall.jsonld"},
    {"overlays", {"may.jsonld", "/etc/opal/june.jsonld"}},
    {"scorers",
     {{{"@type", "likelihood.py:Likelihood"}, {"weight", 1}}, {{"@type", "opal:Beams"}, {"role", "decides"}}}},
};

}  // namespace

TEST_CASE("a deployment for another folder names what lies beside its own file") {
  const ordered_json moved = session::moved_deployment(kDocument, "site/robot.jsonld", "out/deep/robot.jsonld");
  CHECK(moved["map"] == "../../site/hall.jsonld");
  CHECK(moved["overlays"] == ordered_json{"../../site/may.jsonld", "/etc/opal/june.jsonld"});
  CHECK(moved["scorers"][0]["@type"] == "../../site/likelihood.py:Likelihood");
  CHECK(moved["scorers"][1] == kDocument["scorers"][1]);
}

TEST_CASE("a deployment that stays in its folder stays as it is") {
  const std::string to = GENERATE("site/other.jsonld", "./site/other.jsonld", "out/../site/other.jsonld");
  CHECK(session::moved_deployment(kDocument, "site/robot.jsonld", to).dump() == kDocument.dump());
}

TEST_CASE("a map of a store, and a deployment without files, are the same everywhere") {
  const ordered_json document = GENERATE(ordered_json{{"map", "store:hall@3"}}, ordered_json{{"map", ""}},
                                         ordered_json{{"sensor", {{"beams", 360}}}});
  CHECK(session::moved_deployment(document, "site/robot.jsonld", "robot.jsonld") == document);
}
