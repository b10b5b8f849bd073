#pragma once

#include <random>
#include <string>
#include <vector>

/// Damages texts in the ways in which files are damaged, and in some that only malice thinks of. The same seed gives
/// the same damage.
class Mutator {
 public:
  explicit Mutator(unsigned seed) : random_(seed) {}

  /// One to three kinds of damage, one after the other.
  /// @param references  how the format refers to other things: a character that begins a reference ('#' in STEP, '"' in
  /// JSON).
  std::string damaged(const std::string& text, char reference);

 private:
  std::size_t below(std::size_t limit) {
    return limit == 0 ? 0 : std::uniform_int_distribution<std::size_t>(0, limit - 1)(random_);
  }
  std::string once(std::string text, char reference);

  std::string flip_bytes(std::string text);
  std::string cut(const std::string& text);
  std::string without_piece(const std::string& text);
  std::string with_piece_twice(const std::string& text);
  std::string change_lines(const std::string& text);
  std::string change_number(const std::string& text);
  std::string swap_references(std::string text, char reference);
  std::string nest(const std::string& text);
  std::string encode_otherwise(const std::string& text);

  std::mt19937 random_;
};
