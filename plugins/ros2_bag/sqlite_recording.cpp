#include "sqlite_recording.hpp"

#include <opal/common/error.hpp>

#include <fmt/format.h>
#include <sqlite3.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace opal::ros2_bag {
namespace {

using recording::Message;

std::string text_of(sqlite3_stmt* statement, int column) {
  const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(statement, column));
  return text ? text : "";
}

/// A number of the file's header, big endian (SQLite file format, 1.3).
std::uint64_t header_number(const std::string& path, std::streamoff offset, int bytes) {
  std::ifstream file(path, std::ios::binary);
  file.seekg(offset);
  std::uint64_t number = 0;
  for (int k = 0; k < bytes; ++k) number = 256 * number + static_cast<unsigned char>(file.get());
  return number;
}

/// Whether changes are written into another file first.
bool has_write_ahead_log(const std::string& path) { return header_number(path, 19, 1) == 2; }

/// How many bytes the file has by its header.
std::uint64_t stated_bytes(const std::string& path) {
  const std::uint64_t page_bytes = header_number(path, 16, 2);
  constexpr std::uint64_t kLargestPage = 65536;  // written as 1
  return (page_bytes == 1 ? kLargestPage : page_bytes) * header_number(path, 28, 4);
}

/// SQLite reads nothing of a file that was cut, unless it has as many bytes as before, whatever they are.
std::string recovery_of(const std::string& path) {
  std::error_code error;
  const std::uint64_t stated = stated_bytes(path), found = std::filesystem::file_size(path, error);
  if (error || found >= stated) return "; 'sqlite3 " + path + " .dump' tells what is left of it";
  const std::string size = std::to_string(stated);
  return "; it has " + std::to_string(found) + " bytes, expected " + size +
         "; what is left is read of a copy after 'truncate -s " + size + " COPY'";
}

/// A reader of such a file makes two more beside it, unless it is told that nobody writes.
bool is_at_rest(const std::string& path) {
  std::error_code absent;
  const auto waiting_bytes = std::filesystem::file_size(path + "-wal", absent);
  return has_write_ahead_log(path) && (absent || waiting_bytes == 0);
}

/// The file as SQLite is asked for it, by its URI.
std::string uri_of(const std::string& path) {
  constexpr char kHex[] = "0123456789ABCDEF";
  std::string uri = "file://";
  for (const char c : std::filesystem::absolute(path).string()) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '%' || c == '?' || c == '#')
      uri += {'%', kHex[byte / 16], kHex[byte % 16]};
    else
      uri += c;
  }
  return uri + (is_at_rest(path) ? "?immutable=1" : "?mode=ro");
}

/// The rows of a query.
class Rows {
 public:
  Rows(const std::string& path, sqlite3* database, const std::string& query) {
    sqlite3_stmt* statement = nullptr;
    const int result = sqlite3_prepare_v2(database, query.c_str(), -1, &statement, nullptr);
    statement_.reset(statement);
    if (result == SQLITE_CORRUPT) throw DamagedBag(path, sqlite3_errmsg(database));
    if (result != SQLITE_OK)
      throw LogError(path + ": " + sqlite3_errmsg(database) +
                     ", expected the tables topics and messages of a ROS 2 recording");
  }
  /// @return false at the end, or where the file is damaged.
  bool next() {
    const int result = sqlite3_step(statement_.get());
    if (result != SQLITE_ROW && result != SQLITE_DONE) damaged_ = true;
    return result == SQLITE_ROW;
  }
  std::int64_t number(int column) const { return sqlite3_column_int64(statement_.get(), column); }
  std::string text(int column) const { return text_of(statement_.get(), column); }
  recording::Bytes bytes(int column) const {
    const auto* bytes = static_cast<const std::byte*>(sqlite3_column_blob(statement_.get(), column));
    return {bytes, bytes ? static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column)) : 0};
  }
  bool damaged() const { return damaged_; }

 private:
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
  };
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
  bool damaged_ = false;
};

class SqliteWalk final : public recording::MessageWalk {
 public:
  /// @param ids  of topics in the file, by their index
  SqliteWalk(Rows rows, const std::vector<std::int64_t>& ids) : rows_(std::move(rows)), ids_(ids) {}

  std::optional<Message> next() override {
    while (rows_.next()) {
      const auto id = std::find(ids_.begin(), ids_.end(), rows_.number(0));
      if (id != ids_.end())
        return Message{static_cast<std::size_t>(id - ids_.begin()), rows_.number(1), rows_.bytes(2)};
    }
    if (rows_.damaged()) defects_["damaged file"] = 1;
    return std::nullopt;
  }
  const recording::Defects& defects() const override { return defects_; }

 private:
  Rows rows_;
  const std::vector<std::int64_t>& ids_;
  recording::Defects defects_;
};

}  // namespace

DamagedBag::DamagedBag(const std::string& path, const std::string& words)
    : LogError(path + ": a damaged SQLite bag: " + words + recovery_of(path)) {}

void SqliteRecording::Close::operator()(sqlite3* database) const { sqlite3_close_v2(database); }

SqliteRecording::SqliteRecording(const std::string& path) : path_(path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
    throw LogError(path + ": no such file, expected the .db3 file of a ROS 2 recording");
  sqlite3* database = nullptr;
  const int result = sqlite3_open_v2(uri_of(path).c_str(), &database, SQLITE_OPEN_READONLY | SQLITE_OPEN_URI, nullptr);
  database_.reset(database);
  if (result != SQLITE_OK) throw LogError(path + ": cannot be opened: " + sqlite3_errstr(result));
  // The file comes from elsewhere: its schema is not to run functions, and its pages are looked at before use.
  sqlite3_exec(database, "PRAGMA trusted_schema=OFF; PRAGMA cell_size_check=ON", nullptr, nullptr, nullptr);

  Rows rows(path_, database, "SELECT id, name, type, serialization_format FROM topics ORDER BY id");
  while (rows.next()) {
    ids_.push_back(rows.number(0));
    topics_.push_back(
        {rows.text(1), rows.text(2), rows.text(3) == "cdr" ? recording::Wire::cdr : recording::Wire::other});
  }
  if (rows.damaged() && topics_.empty()) throw DamagedBag(path_, sqlite3_errmsg(database));
  Rows first(path_, database, "SELECT min(timestamp) FROM messages");
  if (first.next()) span_ns_ = {first.number(0), first.number(0)};
  Rows last(path_, database, "SELECT max(timestamp) FROM messages");
  if (last.next()) span_ns_.second = last.number(0);
}

std::vector<recording::RecordedStamp> SqliteRecording::stamps() const {
  std::vector<recording::RecordedStamp> stamps;
  Rows rows(path_, database_.get(), "SELECT topic_id, timestamp FROM messages ORDER BY timestamp, id");
  while (rows.next()) {
    const auto id = std::find(ids_.begin(), ids_.end(), rows.number(0));
    if (id != ids_.end()) stamps.push_back({static_cast<std::size_t>(id - ids_.begin()), rows.number(1)});
  }
  return stamps;
}

std::unique_ptr<recording::MessageWalk> SqliteRecording::walk(const std::vector<std::size_t>& topics) const {
  std::vector<std::int64_t> ids;  // numbers: nothing of the file's own text gets into the query
  for (const std::size_t topic : topics) ids.push_back(ids_.at(topic));
  return std::make_unique<SqliteWalk>(
      Rows(path_, database_.get(),
           fmt::format("SELECT topic_id, timestamp, data FROM messages WHERE topic_id IN ({}) ORDER BY timestamp, id",
                       fmt::join(ids, ","))),
      ids_);
}

}  // namespace opal::ros2_bag
