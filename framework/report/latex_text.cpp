#include "report/latex_text.hpp"

#include <array>
#include <cctype>
#include <string_view>
#include <utility>

namespace opal {
namespace {

constexpr std::string_view kInfinity = "∞";

/// Lamport (1994), section 2.2.1: characters that are commands. Brackets would be an argument after the end of a row.
constexpr std::array<std::pair<char, std::string_view>, 15> kLatexCommands{{{'\\', "\\textbackslash{}"},
                                                                            {'{', "\\{"},
                                                                            {'}', "\\}"},
                                                                            {'$', "\\$"},
                                                                            {'&', "\\&"},
                                                                            {'#', "\\#"},
                                                                            {'%', "\\%"},
                                                                            {'_', "\\_"},
                                                                            {'^', "\\textasciicircum{}"},
                                                                            {'~', "\\textasciitilde{}"},
                                                                            {'<', "\\textless{}"},
                                                                            {'>', "\\textgreater{}"},
                                                                            {'|', "\\textbar{}"},
                                                                            {'[', "{[}"},
                                                                            {']', "{]}"}}};

std::string latex_character(char c) {
  for (const auto& [character, command] : kLatexCommands)
    if (character == c) return std::string(command);
  return std::string(1, static_cast<unsigned char>(c) < 0x20 ? ' ' : c);
}

bool is_minus(const std::string& text, std::size_t k) {
  if (text[k] != '-' || k + 1 == text.size()) return false;
  const bool begins = k == 0 || text[k - 1] == ' ' || text[k - 1] == '(';
  return begins && (std::isdigit(static_cast<unsigned char>(text[k + 1])) != 0 ||
                    text.compare(k + 1, kInfinity.size(), kInfinity) == 0);
}

}  // namespace

std::string latex_text(const std::string& text) {
  std::string latex;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (text.compare(k, kInfinity.size(), kInfinity) == 0) {
      latex += "$\\infty$";
      k += kInfinity.size() - 1;
    } else {
      latex += is_minus(text, k) ? "$-$" : latex_character(text[k]);
    }
  }
  return latex;
}

}  // namespace opal
