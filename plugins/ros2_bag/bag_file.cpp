#include "bag_file.hpp"

#include <opal/common/error.hpp>

#include <sqlite3.h>

#include <fmt/format.h>

#include <filesystem>

namespace opal::ros2_bag {
namespace {

constexpr double kSecondsPerNanosecond = 1e-9;

std::string text_of(sqlite3_stmt* statement, int column) {
  const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(statement, column));
  return text ? text : "";
}

double seconds_of(sqlite3_stmt* statement, int column) {
  return kSecondsPerNanosecond * static_cast<double>(sqlite3_column_int64(statement, column));
}

}  // namespace

void BagFile::Close::operator()(sqlite3* database) const { sqlite3_close_v2(database); }
void BagFile::Messages::Finalize::operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }

bool BagFile::Messages::next() {
  const int result = sqlite3_step(statement_.get());
  if (result != SQLITE_ROW && result != SQLITE_DONE) damaged_ = true;
  return result == SQLITE_ROW;
}

std::int64_t BagFile::Messages::topic() const { return sqlite3_column_int64(statement_.get(), 0); }
double BagFile::Messages::recorded_s() const { return seconds_of(statement_.get(), 1); }

Bytes BagFile::Messages::data() const {
  const auto* bytes = static_cast<const std::byte*>(sqlite3_column_blob(statement_.get(), 2));
  return {bytes, bytes ? static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), 2)) : 0};
}

BagFile::BagFile(const std::string& path) : path_(path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
    throw LogError(path + ": no such file, expected the .db3 file of a ROS 2 recording");
  sqlite3* database = nullptr;
  const int result = sqlite3_open_v2(path.c_str(), &database, SQLITE_OPEN_READONLY, nullptr);
  database_.reset(database);
  if (result != SQLITE_OK) throw LogError(path + ": cannot be opened: " + sqlite3_errstr(result));
  // The file comes from elsewhere: its schema is not to run functions, and its pages are looked at before use.
  sqlite3_exec(database, "PRAGMA trusted_schema=OFF; PRAGMA cell_size_check=ON", nullptr, nullptr, nullptr);

  Messages rows = prepare("SELECT id, name, type FROM topics WHERE serialization_format = 'cdr' ORDER BY id");
  while (rows.next())
    topics_.push_back({sqlite3_column_int64(rows.statement_.get(), 0), text_of(rows.statement_.get(), 1),
                       text_of(rows.statement_.get(), 2)});
  Messages span = prepare("SELECT min(timestamp), max(timestamp) FROM messages");
  if (span.next()) {
    begin_s_ = seconds_of(span.statement_.get(), 0);
    end_s_ = seconds_of(span.statement_.get(), 1);
  }
}

BagFile::Messages BagFile::prepare(const std::string& query) const {
  sqlite3_stmt* statement = nullptr;
  const int result = sqlite3_prepare_v2(database_.get(), query.c_str(), -1, &statement, nullptr);
  Messages rows;
  rows.statement_.reset(statement);
  if (result != SQLITE_OK)
    throw LogError(path_ + ": " + sqlite3_errmsg(database_.get()) +
                   ", expected the tables topics and messages of a ROS 2 recording");
  return rows;
}

BagFile::Messages BagFile::messages(const std::vector<std::int64_t>& topics) const {
  std::string ids;  // numbers: nothing of the file's own text gets into the query
  for (const std::int64_t id : topics) ids += fmt::format("{}{}", ids.empty() ? "" : ",", id);
  return prepare("SELECT topic_id, timestamp, data FROM messages WHERE topic_id IN (" + ids +
                 ") ORDER BY timestamp, id");
}

}  // namespace opal::ros2_bag
