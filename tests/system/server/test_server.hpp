#pragma once

#include "tests/kit/temporary_folder.hpp"

#include <sys/types.h>
#include <filesystem>
#include <string>
#include <vector>

namespace opal::store_tests {

/// A PostgreSQL server in a temporary folder, on a unix socket there and on a free port of 127.0.0.1, which knows its
/// superuser by password only. It ends with this object, and with the process at the latest. Run by root, the server
/// runs as the user `postgres`, since PostgreSQL refuses to run as root.
class TestServer {
 public:
  static constexpr const char* kSuperuser = "keeper";
  static constexpr const char* kPassword = "Tr0ub4dor-and-3";  ///< of this one server's only

  /// @return where initdb and postgres are; empty if PostgreSQL or PostGIS is not installed.
  static std::filesystem::path programs();

  /// Starts it, and sets PGHOST, PGPORT, PGUSER, PGPASSWORD and PGDATABASE of this process.
  explicit TestServer(const std::filesystem::path& programs);
  ~TestServer();
  TestServer(const TestServer&) = delete;
  TestServer& operator=(const TestServer&) = delete;

  void stop();   ///< at once, as if the power failed
  void start();  ///< again, on the same port, with the same data

  /// Makes an empty database and the one that PGDATABASE names.
  void use_new_database(const std::string& name);
  std::filesystem::path folder() const { return folder_.path(); }

 private:
  pid_t run(const std::vector<std::string>& arguments) const;
  bool is_ready() const;

  TemporaryFolder folder_;
  std::filesystem::path programs_;
  int port_ = 0;
  pid_t postgres_ = -1;
};

/// The one server of the test program.
TestServer& server();

}  // namespace opal::store_tests
