// Starts the server first, or says why there are no tests.
#include "test_server.hpp"

#include "tests/kit/run_tests.hpp"

#include <iostream>
#include <optional>

namespace {
std::optional<opal::store_tests::TestServer> the_server;
}

opal::store_tests::TestServer& opal::store_tests::server() { return *the_server; }

int main(int argc, char** argv) {
  const auto programs = opal::store_tests::TestServer::programs();
  if (programs.empty()) {
    std::cout << "skipped: PostgreSQL with PostGIS is not installed (Debian: postgresql-15-postgis-3)\n";
    return 77;
  }
  the_server.emplace(programs);
  const int result = run_tests(argc, argv);
  the_server.reset();
  return result;
}
