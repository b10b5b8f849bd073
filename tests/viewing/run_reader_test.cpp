#include "synthetic_run.hpp"
#include "viewer/run_reader.hpp"

#include <catch2/catch.hpp>
TEST_CASE("measure") {
  const char* p = std::getenv("RUN");
  if (!p) return;
  std::size_t n = 0;
  auto r = opal::read_run(p, [&](const opal::RunHeader&, opal::RunFrame&& f) { n += f.hypotheses.size(); return true; });
  WARN(n << " " << r.frames);
}
