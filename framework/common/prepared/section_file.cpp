#include "common/prepared/section_file.hpp"

#include "common/whole_file.hpp"

#include <boost/interprocess/file_mapping.hpp>
#include <boost/interprocess/mapped_region.hpp>

#include <algorithm>
#include <cstring>

namespace opal {
namespace {

namespace bip = boost::interprocess;

constexpr std::size_t kAlignment = 4096;

/// The first bytes of the file.
struct Header {
  std::array<char, 8> magic{'o', 'p', 'a', 'l', 's', 'e', 'c', 't'};
  std::array<char, 8> kind{};
  std::uint32_t version = 1, byte_order = 0x01020304;
  std::array<char, 64> digest{};
  std::array<std::uint64_t, kMostSections> counts{};  ///< of values in each section
};
static_assert(std::is_trivially_copyable_v<Header>);

Header header_of(const SectionKey& key) {
  Header header;
  header.kind = key.kind;
  std::copy_n(key.digest.begin(), std::min(key.digest.size(), header.digest.size()), header.digest.begin());
  return header;
}

std::size_t aligned(std::size_t bytes) { return (bytes + kAlignment - 1) / kAlignment * kAlignment; }

void write_padded(WholeFile& file, std::string_view bytes) {
  file.write(bytes);
  file.write(std::string(aligned(bytes.size()) - bytes.size(), '\0'));
}

}  // namespace

void write_sections(const std::filesystem::path& file, const SectionKey& key, std::span<const Section> sections) {
  Header header = header_of(key);
  for (std::size_t k = 0; k < sections.size(); ++k) header.counts.at(k) = sections[k].count;
  WholeFile whole(file.string());
  write_padded(whole, Section(std::span<const Header>(&header, 1)).bytes);
  for (const Section& section : sections) write_padded(whole, section.bytes);
  whole.finish();
}

std::optional<Sections> Sections::open(const std::filesystem::path& file, const SectionKey& key) try {
  const bip::file_mapping mapping(file.c_str(), bip::read_only);
  const auto region = std::make_shared<bip::mapped_region>(mapping, bip::read_only);
  if (region->get_size() < sizeof(Header)) return std::nullopt;
  Header found, expected = header_of(key);
  std::memcpy(&found, region->get_address(), sizeof(Header));
  expected.counts = found.counts;
  if (std::memcmp(&found, &expected, sizeof(Header)) != 0) return std::nullopt;
  Sections sections;
  sections.region_ = region;
  sections.begin_ = static_cast<const char*>(region->get_address());
  sections.bytes_ = region->get_size();
  sections.at_ = aligned(sizeof(Header));
  sections.counts_ = found.counts;
  return sections;
} catch (const bip::interprocess_exception&) {
  return std::nullopt;
}

const char* Sections::take(std::uint64_t count, std::size_t value_bytes) {
  if (at_ > bytes_ || count > (bytes_ - at_) / value_bytes) {
    is_whole_ = false;
    return nullptr;
  }
  const char* begin = begin_ + at_;
  at_ += aligned(static_cast<std::size_t>(count) * value_bytes);
  return begin;
}

void Sections::let_go() const {
  static_cast<bip::mapped_region*>(region_.get())->advise(bip::mapped_region::advice_dontneed);
}

}  // namespace opal
