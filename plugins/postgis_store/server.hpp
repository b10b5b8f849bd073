#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace opal::postgis_store {

struct ServerOptions {
  int connect_timeout_s = 5;
  int lock_timeout_s = 60;
};

using Row = std::vector<std::string>;  ///< columns as text; NULL is empty

/// What can be asked inside a transaction.
class Session {
 public:
  virtual ~Session() = default;
  /// @param parameters  for $1, $2, ... of `sql`: the only way for foreign text into a statement.
  virtual std::vector<Row> ask(const std::string& sql, const std::vector<std::string>& parameters = {}) = 0;
  /// Several statements without parameters.
  virtual void run(const std::string& script) = 0;
};

/// A PostgreSQL server, reached with what libpq finds in its environment, service file and password file. Connects when
/// first asked. Thread-safe: one transaction at a time.
class Server {
 public:
  explicit Server(const ServerOptions& options);
  ~Server();

  /// "database maps on db.example:5432", from what libpq would use; connects to nothing.
  std::string where() const;

  /// Runs `work` in a transaction, which is committed if it returns.
  /// @throws StoreUnreachable if there is no connection or it breaks; StoreError for what the server refuses. Both with
  /// the server's words and without secrets. What `work` throws by itself comes through.
  void transact(const std::function<void(Session&)>& work) const;
  /// The same on one state of the database, without changing it.
  void read(const std::function<void(Session&)>& work) const;

 private:
  struct Connection;
  template <class Transaction>
  void guarded(const std::function<void(Session&)>& work) const;

  const ServerOptions options_;
  mutable std::mutex mutex_;
  mutable std::unique_ptr<Connection> connection_;
};

}  // namespace opal::postgis_store
