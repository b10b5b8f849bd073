#pragma once

#include <opal/common/error.hpp>
#include <opal/recording/recording.hpp>

struct sqlite3;
struct sqlite3_stmt;

namespace opal::ros2_bag {

/// A file of SQLite of which not even the topics can be read.
class DamagedBag : public LogError {
 public:
  /// @param words  those of SQLite.
  DamagedBag(const std::string& path, const std::string& words);
};

/// One .db3 file of a rosbag2 recording.
class SqliteRecording final : public recording::Recording {
 public:
  /// Leaves nothing beside it, unless another program writes into it. @throws LogError if it is no such file.
  explicit SqliteRecording(const std::string& path);

  /// All topics; those that were not recorded as CDR have another wire.
  const std::vector<recording::Topic>& topics() const override { return topics_; }
  std::pair<std::int64_t, std::int64_t> span_ns() const override { return span_ns_; }
  std::vector<recording::RecordedStamp> stamps() const override;
  std::unique_ptr<recording::MessageWalk> walk(const std::vector<std::size_t>& topics) const override;
  const recording::Defects& defects() const override { return defects_; }

 private:
  struct Close {
    void operator()(sqlite3* database) const;
  };

  std::string path_;
  std::unique_ptr<sqlite3, Close> database_;
  std::vector<recording::Topic> topics_;
  std::vector<std::int64_t> ids_;  // of the topics, in the file
  std::pair<std::int64_t, std::int64_t> span_ns_;
  recording::Defects defects_;
};

}  // namespace opal::ros2_bag
