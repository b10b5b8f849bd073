#include <opal/recording/chunk_codec.hpp>

#include <lz4frame.h>
#include <zlib.h>
#include <zstd.h>

#include <algorithm>

namespace opal::recording {
namespace {

constexpr std::size_t kStepBytes = 1 << 18;

/// Room for the next piece of what comes out: a damaged size must not ask for a gigabyte at once.
Bytes grow(std::vector<std::byte>& out, std::size_t filled, std::uint64_t whole_bytes) {
  out.resize(std::min<std::uint64_t>(whole_bytes, std::max(filled + kStepBytes, 2 * filled)));
  return Bytes(out).subspan(filled);
}

struct FreeLz4 {
  void operator()(LZ4F_dctx* context) const { LZ4F_freeDecompressionContext(context); }
};
struct FreeZstd {
  void operator()(ZSTD_DCtx* context) const { ZSTD_freeDCtx(context); }
};

/// One step of a decoder.
struct Step {
  std::size_t used = 0, made = 0;
  std::string damage;
  bool is_end = false;
};

class Lz4Steps {
 public:
  Lz4Steps() {
    LZ4F_dctx* context = nullptr;
    LZ4F_createDecompressionContext(&context, LZ4F_VERSION);
    context_.reset(context);
  }
  Step step(Bytes room, Bytes packed) {
    Step step{packed.size(), room.size(), {}};
    const std::size_t result = LZ4F_decompress(context_.get(), const_cast<std::byte*>(room.data()), &step.made,
                                               packed.data(), &step.used, nullptr);
    if (LZ4F_isError(result)) return {0, 0, std::string("lz4: ") + LZ4F_getErrorName(result)};
    step.is_end = result == 0;
    return step;
  }

 private:
  std::unique_ptr<LZ4F_dctx, FreeLz4> context_;
};

class ZstdSteps {
 public:
  ZstdSteps() : context_(ZSTD_createDCtx()) {}
  Step step(Bytes room, Bytes packed) {
    ZSTD_inBuffer in{packed.data(), packed.size(), 0};
    ZSTD_outBuffer out{const_cast<std::byte*>(room.data()), room.size(), 0};
    const std::size_t result = ZSTD_decompressStream(context_.get(), &out, &in);
    if (ZSTD_isError(result)) return {0, out.pos, std::string("zstd: ") + ZSTD_getErrorName(result)};
    return {in.pos, out.pos, {}, result == 0 && in.pos == in.size};
  }

 private:
  std::unique_ptr<ZSTD_DCtx, FreeZstd> context_;
};

template <class Steps>
Unpacked unpack_steps(Steps steps, Bytes packed, std::uint64_t whole_bytes) {
  Unpacked unpacked;
  std::size_t filled = 0;
  std::byte nothing{};
  while (true) {
    Bytes room = grow(unpacked.bytes, filled, whole_bytes);
    if (room.empty()) room = Bytes(&nothing, 0);
    const Step step = steps.step(room, packed);
    filled += step.made;
    packed = packed.subspan(step.used);
    unpacked.damage = step.damage;
    if (!step.damage.empty() || step.is_end || (step.used == 0 && step.made == 0)) break;
  }
  unpacked.bytes.resize(filled);
  return unpacked;
}

std::vector<std::byte> pack_lz4(Bytes whole) {
  std::vector<std::byte> packed(LZ4F_compressFrameBound(whole.size(), nullptr));
  packed.resize(LZ4F_compressFrame(packed.data(), packed.size(), whole.data(), whole.size(), nullptr));
  return packed;
}

std::vector<std::byte> pack_zstd(Bytes whole) {
  constexpr int kLevel = 1;  // a robot records with what it does not need for driving
  std::vector<std::byte> packed(ZSTD_compressBound(whole.size()));
  packed.resize(ZSTD_compress(packed.data(), packed.size(), whole.data(), whole.size(), kLevel));
  return packed;
}

}  // namespace

void expect_chunk_size(std::uint64_t whole_bytes) {
  if (whole_bytes > kMostChunkBytes)
    throw Damage("a chunk of " + std::to_string(whole_bytes) + " bytes, expected at most " +
                 std::to_string(kMostChunkBytes));
}

Unpacked unpack_chunk(const std::string& compression, Bytes packed, std::uint64_t whole_bytes) {
  expect_chunk_size(whole_bytes);
  Unpacked unpacked;
  if (compression == "zstd")
    unpacked = unpack_steps(ZstdSteps(), packed, whole_bytes);
  else if (compression == "lz4")
    unpacked = unpack_steps(Lz4Steps(), packed, whole_bytes);
  else if (compression.empty())
    unpacked.bytes.assign(packed.begin(), packed.end());
  else
    throw Damage("a chunk packed with '" + compression + "', expected lz4, zstd or nothing");
  if (unpacked.damage.empty() && unpacked.bytes.size() != whole_bytes)
    unpacked.damage =
        std::to_string(unpacked.bytes.size()) + " bytes come out of it, expected " + std::to_string(whole_bytes);
  return unpacked;
}

std::vector<std::byte> pack_chunk(const std::string& compression, Bytes whole) {
  if (compression == "zstd") return pack_zstd(whole);
  if (compression == "lz4") return pack_lz4(whole);
  return {whole.begin(), whole.end()};
}

std::uint32_t crc32_of(Bytes bytes, std::uint32_t before) {
  return static_cast<std::uint32_t>(
      crc32_z(before, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()));
}

}  // namespace opal::recording
