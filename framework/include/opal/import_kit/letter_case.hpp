#pragma once

#include <string>
#include <vector>

namespace opal {

/// A text in UTF-8 with its Latin (with accents), Greek and Cyrillic letters in upper case. What is no UTF-8 stays as
/// it is.
std::string upper_case_letters(const std::string& text);

/// The words of a name in upper case: "0_Murature 2" has MURATURE. Whatever is no letter divides words, and so does the
/// step from a small letter to a capital.
std::vector<std::string> words_of_name(const std::string& name);

}  // namespace opal
