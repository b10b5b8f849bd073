#include "event_stream_client.hpp"

#include <httplib.h>

#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

std::vector<Message> parse_messages(const std::string& stream) {
  std::vector<Message> messages;
  std::istringstream lines(stream);
  Message message;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty()) {
      if (!message.data.empty()) messages.push_back(message);
      message = {};
    }
    if (line.starts_with("id: ")) message.id = line.substr(4);
    if (line.starts_with("event: ")) message.kind = line.substr(7);
    if (line.starts_with("data: ")) message.data = line.substr(6);
  }
  return messages;
}

EventStreamClient::EventStreamClient(int port, const std::map<std::string, std::string>& headers)
    : client_(std::make_unique<httplib::Client>("127.0.0.1", port)) {
  client_->set_read_timeout(60);
  thread_ = std::thread([this, headers = httplib::Headers(headers.begin(), headers.end())] {
    const auto result = client_->Get("/events", headers, [this](const char* data, std::size_t size) {
      std::lock_guard lock(mutex_);
      text_.append(data, size);
      count_ += static_cast<std::size_t>(std::count(data, data + size, '\n'));
      grown_.notify_all();
      return true;
    });
    std::lock_guard lock(mutex_);
    status_ = result ? result->status : 0;
    over_ = true;
    grown_.notify_all();
  });
}

EventStreamClient::~EventStreamClient() {
  client_->stop();
  thread_.join();
}

std::vector<Message> EventStreamClient::wait_for(std::size_t count) {
  std::unique_lock lock(mutex_);
  constexpr std::size_t kLinesPerMessage = 3;
  grown_.wait(lock, [&] { return over_ || count_ >= kLinesPerMessage * count; });
  return parse_messages(text_);
}

std::vector<Message> EventStreamClient::wait_for_end() {
  std::unique_lock lock(mutex_);
  grown_.wait(lock, [&] { return over_; });
  return parse_messages(text_);
}

int EventStreamClient::status() {
  wait_for_end();
  return status_;
}

StalledClient::StalledClient(int port) : socket_(socket(AF_INET, SOCK_STREAM, 0)) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const std::string request = "GET /events HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port) + "\r\n\r\n";
  if (connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 ||
      send(socket_, request.data(), request.size(), 0) != static_cast<ssize_t>(request.size()))
    throw std::runtime_error("cannot connect");
}

StalledClient::~StalledClient() { close(socket_); }
