#pragma once

#include <opal/common/export.hpp>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace opal {

/// A text in UTF-8 with all its letters in upper case, as Unicode has it. Bytes that are no UTF-8 stay as they are.
OPAL_EXPORT std::string upper_case_letters(const std::string& text);
/// The same in lower case.
OPAL_EXPORT std::string lower_case_letters(const std::string& text);

/// The words of a name in upper case: "0_Murature 2" has MURATURE. Whatever is no letter divides words, and so does the
/// step from a small letter to a capital.
OPAL_EXPORT std::vector<std::string> words_of_name(const std::string& name);
/// Whether one of the words is a known one.
OPAL_EXPORT bool has_any_word(const std::vector<std::string>& words, std::span<const std::string_view> known);

}  // namespace opal
