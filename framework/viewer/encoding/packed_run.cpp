#include "viewer/encoding/packed_run.hpp"

#include "viewer/encoding/record_packer.hpp"

#include <opal/common/error.hpp>

#include <optional>

namespace opal {
namespace {

/// One level of detail: given up when it becomes too large.
class Packing {
 public:
  explicit Packing(const PageDetail& detail) : detail_(detail), encoder_(detail) {}

  void begin(const RunHeader& header) {
    packer_.add(encoder_.run_record(header));
    packer_.add(encoder_.map_record(header));
  }
  void add(const RunFrame& frame, const Words& words) { packer_.add(encoder_.frame_record(frame, words)); }
  std::size_t size() const { return packer_.size(); }
  std::string finish() { return packer_.finish(); }
  const PageDetail& detail() const { return detail_; }

 private:
  const PageDetail& detail_;
  PageEncoder encoder_;
  RecordPacker packer_;
};

/// What becomes of the coarsest level if it is too large, too.
enum class CoarsestLevel { within_limit, always_kept };

/// Packs frames with several levels of detail at once, finest first, and keeps those that fit.
class Packings {
 public:
  Packings(std::span<const PageDetail> details, std::size_t limit, CoarsestLevel coarsest,
           const MakeNarrator& make_narrator)
      : limit_(limit), keep_last_(coarsest == CoarsestLevel::always_kept), narrate_(make_narrator()) {
    for (const PageDetail& detail : details) packings_.push_back(std::make_unique<Packing>(detail));
  }

  /// @return whether any level still fits
  bool take(const RunHeader& header, RunFrame&& frame) {
    if (newest_) {
      add_newest({});
    } else {
      for (const auto& packing : packings_) packing->begin(header);
    }
    words_ = narrate_(header, frame);
    newest_ = std::move(frame);
    give_up_too_large();
    return !packings_.empty();
  }

  /// The finest that fits. @pre a frame was taken
  std::optional<PackedRun> finish(const std::vector<std::string>& notes) {
    if (packings_.empty()) return std::nullopt;
    add_newest(notes);
    for (const auto& packing : packings_) {
      std::string data = packing->finish();
      const bool last = packing == packings_.back() && keep_last_;
      if (data.size() <= limit_ || last) return PackedRun{"", std::move(data), 0, notes, packing->detail().reduced};
    }
    return std::nullopt;
  }

 private:
  /// The newest frame waits for the next: what is said about the end of the stream belongs to the last one.
  void add_newest(const std::vector<std::string>& notes) {
    for (const std::string& note : notes) words_.emplace_back("note", note);
    for (const auto& packing : packings_) packing->add(*newest_, words_);
  }

  void give_up_too_large() {
    while (!packings_.empty() && packings_.front()->size() > limit_ && !(keep_last_ && packings_.size() == 1))
      packings_.erase(packings_.begin());
  }

  const std::size_t limit_;
  const bool keep_last_;
  Narrator narrate_;
  std::vector<std::unique_ptr<Packing>> packings_;
  std::optional<RunFrame> newest_;
  Words words_;
};

std::optional<PackedRun> try_to_pack(const std::string& out, Packings packings) {
  const RunReading reading =
      read_run(out, [&](const RunHeader& header, RunFrame&& frame) { return packings.take(header, std::move(frame)); });
  if (reading.frames == 0) throw EventError(event_file(out) + ": holds no update, expected at least one");
  std::optional<PackedRun> packed = packings.finish(reading.notes);
  if (packed) packed->frames = reading.frames;
  return packed;
}

}  // namespace

PackedRun pack_run(const std::string& out, const std::string& name, std::size_t limit,
                   const MakeNarrator& make_narrator) {
  const auto details = page_details();
  // Most runs fit as they are; the others are read again, for all coarser levels together.
  std::optional<PackedRun> packed =
      try_to_pack(out, {details.first(1), limit, CoarsestLevel::within_limit, make_narrator});
  if (!packed) packed = try_to_pack(out, {details.subspan(1), limit, CoarsestLevel::always_kept, make_narrator});
  packed->name = name;
  return *std::move(packed);
}

}  // namespace opal
