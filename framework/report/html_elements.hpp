#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace opal {

/// The parts of a page. What is called `html` is put in as it is, what is called `text` is escaped.

/// @param kind  its class in page/style.css; empty: none.
std::string element(const std::string& tag, const std::string& html, const std::string& kind = "");
std::string text_element(const std::string& tag, const std::string& text, const std::string& kind = "");

/// An element in a link, or just the element if there is no target.
std::string linked(const std::string& target, const std::string& html);

std::string figure(const std::string& html, const std::string& caption_text, const std::string& kind = "");
std::string details(const std::string& summary_text, const std::string& html, bool open = false);

/// What the colours of a picture mean: class and text each.
std::string colour_key(const std::vector<std::pair<std::string, std::string>>& meanings);

/// A link that saves a text as a file; the text is in the page.
std::string download(const std::string& file_name, const std::string& text);

/// A name for "these inline texts", for a Content-Security-Policy: the same whenever they are. What is escaped cannot
/// begin an element, so that it need not be secret.
std::string inline_nonce(const std::vector<std::string_view>& texts);

/// A page that stands alone: nothing is fetched, and no script runs but that which draws its plots, if it has any.
std::string html_page(const std::string& title_text, const std::string& body_html);

}  // namespace opal
