#pragma once

#include <memory>
#include <string>
#include <string_view>

struct z_stream_s;

namespace opal {

/// Packs records into base64 of gzip, one after the other.
class RecordPacker {
 public:
  RecordPacker();
  RecordPacker(RecordPacker&&) noexcept;
  ~RecordPacker();

  /// @param record  one line, without its newline
  void add(std::string_view record);
  /// Characters so far; a little behind, as the compressor looks ahead.
  std::size_t size() const;
  /// Ends the block. The packer is of no further use.
  std::string finish();

 private:
  void deflate_all(std::string_view input, int flush);

  std::unique_ptr<z_stream_s> stream_;
  std::string compressed_;
};

/// Base64 (RFC 4648, section 4), padded.
std::string base64(std::string_view bytes);

}  // namespace opal
