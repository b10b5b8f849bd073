#include "benchmark/ab/records/journal.hpp"

#include <opal/common/error.hpp>
#include "common/write_error.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <unistd.h>
#include <zlib.h>

#include <cerrno>
#include <fstream>
#include <optional>

namespace opal::ab {
namespace {

using nlohmann::ordered_json;

const std::string kBegin = R"({"crc32":")", kMiddle = R"(","cell":)", kEnd = "}";
constexpr std::size_t kDigits = 8;

std::string checksum(std::string_view text) {
  const auto crc = crc32(0, reinterpret_cast<const Bytef*>(text.data()), static_cast<uInt>(text.size()));
  return fmt::format("{:08x}", crc);
}

/// What stands between checksum and end, if the checksum is right.
std::optional<std::string> checked_cell(const std::string& line) {
  const std::size_t from = kBegin.size() + kDigits + kMiddle.size();
  if (line.size() < from + kEnd.size() || line.compare(0, kBegin.size(), kBegin) != 0) return std::nullopt;
  const std::string cell = line.substr(from, line.size() - from - kEnd.size());
  if (line.substr(kBegin.size(), kDigits) != checksum(cell)) return std::nullopt;
  return cell;
}

/// Calls with every whole line. @return how long they are together.
std::uint64_t for_each_line(const std::string& path,
                            const std::function<void(const std::string&, JournalPlace, int)>& take) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw Error(path + ": cannot be read");
  std::uint64_t offset = 0;
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    if (file.eof()) break;  // no end of line: a worker was killed while it wrote
    take(line, {offset, static_cast<std::uint32_t>(line.size())}, number);
    offset += line.size() + 1;
  }
  return offset;
}

}  // namespace

std::string journal_line(const CellResult& result) {
  const std::string cell = ordered_json{
      {"number", result.number},
      {"input", result.input},
      {"values", result.values},
      {"costs", result.costs},
      {"failure",
       result.failure}}.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
  return kBegin + checksum(cell) + kMiddle + cell + kEnd;
}

CellResult parse_journal_line(const std::string& line, const std::string& place) {
  const auto cell = checked_cell(line);
  if (!cell)
    throw Error(place +
                ": damaged, expected a finished cell with its checksum; delete the line to have it computed again");
  const auto json = nlohmann::json::parse(*cell);
  CellResult result;
  result.number = json.at("number");
  result.input = json.at("input");
  json.at("values").get_to(result.values);
  json.at("costs").get_to(result.costs);
  result.failure = json.at("failure");
  return result;
}

void read_journal(const std::string& path, const std::function<void(const CellResult&, JournalPlace)>& take) {
  for_each_line(path, [&](const std::string& line, JournalPlace place, int number) {
    take(parse_journal_line(line, fmt::format("{}: line {}", path, number)), place);
  });
}

Journal::Journal(const std::string& path) : path_(path), file_(open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
  if (file_ < 0) throw WriteError(path, errno);
  const auto whole = for_each_line(path, [](const std::string&, JournalPlace, int) {});
  if (ftruncate(file_, static_cast<off_t>(whole)) != 0 || lseek(file_, 0, SEEK_END) < 0) throw WriteError(path, errno);
}

Journal::~Journal() { close(file_); }

void Journal::append(const CellResult& result) {
  const std::string line = journal_line(result) + "\n";
  errno = 0;
  const ssize_t count = write(file_, line.data(), line.size());
  const bool is_cut = count >= 0 && count != static_cast<ssize_t>(line.size());
  if (is_cut) throw WriteError(path_, ENOSPC);
  if (count < 0 || fdatasync(file_) != 0) throw WriteError(path_, errno);
}

}  // namespace opal::ab
