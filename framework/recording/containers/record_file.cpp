#include <opal/common/error.hpp>
#include <opal/recording/chunked_recording.hpp>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace opal::recording {

RecordFile::RecordFile(std::unique_ptr<std::istream> stream) : stream_(std::move(stream)) {
  stream_->seekg(0, std::ios::end);
  const auto end = stream_->tellg();
  size_ = end > 0 ? static_cast<std::uint64_t>(end) : 0;
}
RecordFile::~RecordFile() = default;
RecordFile::RecordFile(RecordFile&&) noexcept = default;
RecordFile& RecordFile::operator=(RecordFile&&) noexcept = default;

std::vector<std::byte> RecordFile::read(std::uint64_t offset, std::uint64_t count) const {
  if (offset >= size_) return {};
  std::vector<std::byte> bytes(std::min(count, size_ - offset));
  stream_->clear();
  stream_->seekg(static_cast<std::streamoff>(offset));
  stream_->read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(stream_->gcount(), 0)));
  return bytes;
}

RecordFile open_record_file(const std::string& path, const std::string& expected) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) throw LogError(path + ": no such file, expected " + expected);
  if (!std::filesystem::is_regular_file(status)) throw LogError(path + ": is no regular file, expected " + expected);
  auto stream = std::make_unique<std::ifstream>(path, std::ios::binary);
  if (!*stream) throw LogError(path + ": cannot be opened: " + std::strerror(errno));
  return RecordFile(std::move(stream));
}

}  // namespace opal::recording
