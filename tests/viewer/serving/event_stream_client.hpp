#pragma once

#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace httplib {
class Client;
}

/// What a browser's EventSource makes of a stream.
struct Message {
  std::string kind = "message", id, data;
};

std::vector<Message> parse_messages(const std::string& stream);

/// Reads `/events` in a thread of its own, until the server ends the stream or the client is closed.
class EventStreamClient {
 public:
  explicit EventStreamClient(int port, const std::map<std::string, std::string>& headers = {});
  ~EventStreamClient();

  /// Blocks until that many messages have come, or the stream is over.
  std::vector<Message> wait_for(std::size_t count);
  /// Blocks until the stream is over. @return what came.
  std::vector<Message> wait_for_end();
  int status();  ///< blocks until the stream is over

 private:
  std::unique_ptr<httplib::Client> client_;
  std::mutex mutex_;
  std::condition_variable grown_;
  std::string text_;
  std::size_t count_ = 0;
  int status_ = 0;
  bool over_ = false;
  std::thread thread_;
};

/// Connects, asks for `/events`, and never reads.
class StalledClient {
 public:
  explicit StalledClient(int port);
  ~StalledClient();

 private:
  int socket_;
};
