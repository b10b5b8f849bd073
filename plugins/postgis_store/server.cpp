// The one file that knows libpqxx (6.4, Debian 12) and libpq.
#include "server.hpp"

#include "secrets.hpp"

#include <opal/map/map_store.hpp>

#include <libpq-fe.h>
#include <pqxx/pqxx>

#include <fmt/format.h>

#include <cstdlib>

namespace opal::postgis_store {
namespace {

/// A network that swallows packets shows after half a minute, not after the two hours of TCP's defaults.
std::string connection_string(const ServerOptions& options) {
  std::string text =
      "application_name=opal client_encoding=UTF8 keepalives_idle=10 keepalives_interval=5 keepalives_count=4 "
      "tcp_user_timeout=30000";
  if (std::getenv("PGCONNECT_TIMEOUT") == nullptr)
    text += fmt::format(" connect_timeout={}", options.connect_timeout_s);
  return text;
}

/// A pusher that vanished without a word must not keep the others waiting.
std::string session_settings(const ServerOptions& options) {
  const std::string seconds = std::to_string(options.lock_timeout_s);
  return "SET client_min_messages = warning; SET lock_timeout = '" + seconds +
         "s'; SET idle_in_transaction_session_timeout = '" + seconds + "s'; SET extra_float_digits = 1";
}

template <class Transaction>
class PqxxSession final : public Session {
 public:
  explicit PqxxSession(Transaction& transaction) : transaction_(transaction) {}

  std::vector<Row> ask(const std::string& sql, const std::vector<std::string>& parameters) override {
    const pqxx::result result =
        transaction_.exec_params(sql, pqxx::prepare::make_dynamic_params(parameters.begin(), parameters.end()));
    std::vector<Row> rows;
    rows.reserve(result.size());
    for (const pqxx::row& row : result) {
      rows.emplace_back();
      for (const pqxx::field& field : row) rows.back().emplace_back(field.c_str(), field.size());
    }
    return rows;
  }

  void run(const std::string& script) override { transaction_.exec(script); }

 private:
  Transaction& transaction_;
};

/// The server ended the session (57P..), or the way to it did (08...); or libpq itself speaks, because no server does.
bool is_end_of_session(const std::string& sqlstate) {
  return sqlstate.empty() || sqlstate.starts_with("08") || sqlstate.starts_with("57P") || sqlstate == "25P03";
}

std::string libpq_default(const std::string& keyword) {
  std::string value;
  PQconninfoOption* defaults = PQconndefaults();
  for (const PQconninfoOption* option = defaults; option != nullptr && option->keyword != nullptr; ++option)
    if (option->keyword == keyword && option->val != nullptr) value = option->val;
  PQconninfoFree(defaults);
  return value;
}

}  // namespace

struct Server::Connection {
  explicit Connection(const ServerOptions& options) : server(connection_string(options)) {
    pqxx::nontransaction setup(server);
    setup.exec(session_settings(options));
  }
  pqxx::connection server;
};

Server::Server(const ServerOptions& options) : options_(options) {}
Server::~Server() = default;

std::string Server::where() const {
  std::string database = libpq_default("dbname"), host = libpq_default("host");
  if (database.empty()) database = libpq_default("user");
  if (host.empty()) host = libpq_default("hostaddr");
  if (host.empty()) host = "localhost";
  return without_secrets("database " + database + " on " + host + ":" + libpq_default("port"));
}

template <class Transaction>
void Server::guarded(const std::function<void(Session&)>& work) const {
  const std::lock_guard lock(mutex_);
  std::string unreachable, refused;  // texts, so that no exception of libpqxx leaves this library
  try {
    if (!connection_) connection_ = std::make_unique<Connection>(options_);
    Transaction transaction(connection_->server);
    PqxxSession<Transaction> session(transaction);
    work(session);
    transaction.commit();
    return;
  } catch (const pqxx::broken_connection& error) {
    unreachable = std::string(connection_ ? "the connection broke: " : "") + error.what();
  } catch (const pqxx::in_doubt_error&) {
    unreachable = "the connection broke in the very moment of the commit: see in the list whether it took place";
  } catch (const pqxx::sql_error& error) {
    (is_end_of_session(error.sqlstate()) ? unreachable : refused) = error.what();
  } catch (const pqxx::pqxx_exception& error) {
    refused = error.base().what();
  }
  if (unreachable.empty() && connection_ && !connection_->server.is_open())
    unreachable = "the connection broke: " + refused;
  if (!unreachable.empty()) connection_.reset();
  if (!unreachable.empty()) throw StoreUnreachable(where() + ": " + without_secrets(unreachable));
  throw StoreError(where() + ": " + without_secrets(refused));
}

void Server::transact(const std::function<void(Session&)>& work) const { guarded<pqxx::work>(work); }

void Server::read(const std::function<void(Session&)>& work) const {
  guarded<pqxx::transaction<pqxx::repeatable_read, pqxx::read_only>>(work);
}

}  // namespace opal::postgis_store
