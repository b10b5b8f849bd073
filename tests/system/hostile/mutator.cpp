#include "mutator.hpp"

#include "tests/kit/file_content.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace {

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  return text;
}

bool is_of_number(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-' || c == 'e' || c == 'E' || c == '+';
}

/// From the first digit at or after a place to the number's end; empty if there is none.
std::pair<std::size_t, std::size_t> number_after(const std::string& text, std::size_t at) {
  while (at < text.size() && std::isdigit(static_cast<unsigned char>(text[at])) == 0) ++at;
  std::size_t begin = at;
  while (begin > 0 && is_of_number(text[begin - 1])) --begin;
  while (at < text.size() && is_of_number(text[at])) ++at;
  return {begin, at};
}

std::size_t reference_end(const std::string& text, std::size_t begin, char reference) {
  if (reference == '"') return std::min(text.find('"', begin + 1), text.size() - 1) + 1;
  std::size_t end = begin + 1;
  while (end < text.size() && std::isalnum(static_cast<unsigned char>(text[end])) != 0) ++end;
  return end;
}

}  // namespace

std::string Mutator::flip_bytes(std::string text) {
  for (std::size_t k = 1 + below(8); k > 0 && !text.empty(); --k)
    text[below(text.size())] ^= static_cast<char>(1U << below(8));
  return text;
}

std::string Mutator::cut(const std::string& text) { return text.substr(0, below(text.size())); }

std::string Mutator::without_piece(const std::string& text) {
  const std::size_t begin = below(text.size());
  return text.substr(0, begin) + text.substr(std::min(text.size(), begin + 1 + below(200)));
}

std::string Mutator::with_piece_twice(const std::string& text) {
  const std::size_t begin = below(text.size()), length = 1 + below(400);
  const std::string piece = text.substr(begin, length);
  std::string damaged = text;
  return damaged.insert(below(text.size()), piece);
}

std::string Mutator::change_lines(const std::string& text) {
  std::vector<std::string> lines = opal::lines_of(text);
  if (lines.empty()) return text;
  const std::size_t a = below(lines.size()), b = below(lines.size()), count = 1 + below(6);
  const auto at = [&](std::size_t k) { return lines.begin() + static_cast<std::ptrdiff_t>(k); };
  switch (below(4)) {
    case 0: lines.erase(at(a), at(std::min(lines.size(), a + count))); break;
    case 1: lines.insert(at(a), lines[b]); break;
    case 2: std::swap(lines[a], lines[b]); break;
    default: std::rotate(at(std::min(a, b)), at((a + b) / 2), at(std::max(a, b))); break;
  }
  return joined(lines);
}

std::string Mutator::change_number(const std::string& text) {
  static const std::array<const char*, 16> kNumbers{
      "1e308", "-1e308", "1e999",  "NaN",  "nan", "inf", "-inf", "2147483648", "-2147483649", "99999999999999999999",
      "0",     "-1",     "1e-320", "0x7f", "1,5", ""};
  const auto [begin, end] = number_after(text, below(text.size()));
  return text.substr(0, begin) + kNumbers[below(kNumbers.size())] + text.substr(end);
}

std::string Mutator::swap_references(std::string text, char reference) {
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < text.size(); ++k)
    if (text[k] == reference) places.push_back(k);
  if (places.size() < 2) return text;
  for (std::size_t k = 1 + below(3); k > 0; --k) {
    const std::size_t from = places[below(places.size())], to = places[below(places.size())];
    const std::string piece = text.substr(from, reference_end(text, from, reference) - from);
    if (to < text.size()) text.replace(to, reference_end(text, to, reference) - to, piece);
  }
  return text;
}

std::string Mutator::nest(const std::string& text) {
  static const std::array<const char*, 5> kOpenings{"[", "{\"a\":", "(", "0\nBLOCK\n2\nN\n", "\""};
  std::string nested;
  const char* opening = kOpenings[below(kOpenings.size())];
  for (std::size_t k = 1 + below(3000); k > 0; --k) nested += opening;
  std::string damaged = text;
  return damaged.insert(below(text.size()), nested);
}

std::string Mutator::encode_otherwise(const std::string& text) {
  std::string encoded;
  switch (below(5)) {
    case 0: return "\xEF\xBB\xBF" + text;
    case 1:
      for (const char c : text) encoded += c == '\n' ? std::string("\r\n") : std::string(1, c);
      return encoded;
    case 2:
      for (const char c : text) encoded += c == '\n' ? '\r' : c;
      return encoded;
    case 3:
      encoded = "\xFF\xFE";
      for (const char c : text) encoded += std::string{c, '\0'};
      return encoded;
    default: return std::string(1 + below(64), '\0') + text;
  }
}

std::string Mutator::once(std::string text, char reference) {
  if (text.empty()) return text;
  switch (below(12)) {
    case 0:
    case 1: return flip_bytes(std::move(text));
    case 2: return cut(text);
    case 3: return without_piece(text);
    case 4: return with_piece_twice(text);
    case 5:
    case 6: return change_lines(text);
    case 7:
    case 8: return change_number(text);
    case 9: return swap_references(std::move(text), reference);
    case 10: return nest(text);
    default: return encode_otherwise(text);
  }
}

std::string Mutator::damaged(const std::string& text, char reference) {
  std::string damaged = text;
  for (std::size_t k = 1 + below(5) / 2; k > 0; --k) damaged = once(std::move(damaged), reference);
  return damaged;
}
