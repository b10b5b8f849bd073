#pragma once

#include "messages.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

struct sqlite3;
struct sqlite3_stmt;

namespace opal::ros2_bag {

struct Topic {
  std::int64_t id = 0;
  std::string name;
  std::string type;
};

/// One .db3 file of a rosbag2 recording.
class BagFile {
 public:
  /// @throws LogError if it is no such file.
  explicit BagFile(const std::string& path);

  const std::string& path() const { return path_; }
  const std::vector<Topic>& topics() const { return topics_; }  ///< those recorded as CDR

  /// Messages of some topics in the order of their recording.
  class Messages {
   public:
    /// @return false at the end, or where the file is damaged.
    bool next();
    std::int64_t topic() const;
    double recorded_s() const;
    Bytes data() const;  ///< valid until the next one
    bool damaged() const { return damaged_; }

   private:
    friend class BagFile;
    struct Finalize {
      void operator()(sqlite3_stmt* statement) const;
    };
    std::unique_ptr<sqlite3_stmt, Finalize> statement_;
    bool damaged_ = false;
  };
  Messages messages(const std::vector<std::int64_t>& topics) const;

  double begin_s() const { return begin_s_; }  ///< when the first message was recorded
  double end_s() const { return end_s_; }

 private:
  struct Close {
    void operator()(sqlite3* database) const;
  };

  Messages prepare(const std::string& query) const;

  std::string path_;
  std::unique_ptr<sqlite3, Close> database_;
  std::vector<Topic> topics_;
  double begin_s_ = 0;
  double end_s_ = 0;
};

}  // namespace opal::ros2_bag
