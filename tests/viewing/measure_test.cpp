#include "viewer/packed_run.hpp"

#include <catch2/catch.hpp>
TEST_CASE("measure pack") {
  const char* p = std::getenv("RUN");
  if (!p) return;
  auto r = opal::pack_run(p, "x", 15000000 - 600000, [] { return [](const opal::RunHeader&, const opal::RunFrame&) { return opal::Words{}; }; });
  WARN(r.data.size() << " " << r.frames << " " << (r.reduced.empty() ? "" : r.reduced[0]));
}
