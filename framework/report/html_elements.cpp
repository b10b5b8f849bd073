#include "report/html_elements.hpp"

#include "report/html_text.hpp"
#include "report/page_assets.hpp"

#include <fmt/format.h>

#include <cstdint>

namespace opal {
namespace {

/// FNV-1a (Fowler, Noll, Vo) with an offset of one's choice.
std::uint64_t hash(std::string_view text, std::uint64_t offset) {
  for (const char c : text) offset = (offset ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  return offset;
}

/// RFC 3986: everything but unreserved characters.
std::string percent_encoded(const std::string& text) {
  std::string encoded;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain =
        byte < 0x80 && (std::isalnum(byte) || std::string_view("-._~").find(c) != std::string_view::npos);
    encoded += plain ? std::string(1, c) : fmt::format("%{:02X}", byte);
  }
  return encoded;
}

}  // namespace

std::string element(const std::string& tag, const std::string& html, const std::string& kind) {
  return fmt::format("<{}{}>{}</{}>", tag, kind.empty() ? "" : " class=\"" + html_text(kind) + "\"", html, tag);
}

std::string text_element(const std::string& tag, const std::string& text, const std::string& kind) {
  return element(tag, html_text(text, tag == "pre"), kind) + "\n";
}

std::string linked(const std::string& target, const std::string& html) {
  return target.empty() ? html : fmt::format("<a href=\"{}\">{}</a>", html_text(target), html);
}

std::string figure(const std::string& html, const std::string& caption_text, const std::string& kind) {
  return element("figure", text_element("figcaption", caption_text) + html, kind) + "\n";
}

std::string details(const std::string& summary_text, const std::string& html, bool open) {
  return fmt::format("<details{}>{}{}</details>\n", open ? " open" : "", text_element("summary", summary_text), html);
}

std::string colour_key(const std::vector<std::pair<std::string, std::string>>& meanings) {
  std::string html;
  for (const auto& [kind, text] : meanings) html += element("i", "", kind) + html_text(text);
  return element("p", html, "key quiet") + "\n";
}

std::string download(const std::string& file_name, const std::string& text) {
  const std::string name = html_text(file_name);
  return fmt::format("<p class=\"download\"><a download=\"{}\" href=\"data:text/plain;charset=utf-8,{}\">{}</a></p>\n",
                     name, percent_encoded(text), name);
}

std::string inline_nonce(const std::vector<std::string_view>& texts) {
  std::uint64_t first = 0xcbf29ce484222325u, second = 0x84222325cbf29ce4u;
  for (const std::string_view text : texts) first = hash(text, first), second = hash(text, second);
  return fmt::format("{:016x}{:016x}", first, second);
}

std::string html_page(const std::string& title_text, const std::string& body_html) {
  const bool plots = body_html.find("<div class=\"plot\"") != std::string::npos;
  const std::string nonce = inline_nonce({body_html, kReportStyle, kReportScript});
  const std::string policy =
      fmt::format("default-src 'none'; style-src 'unsafe-inline'; script-src {}; base-uri 'none'; form-action 'none'",
                  plots ? "'nonce-" + nonce + "'" : "'none'");
  return fmt::format(
             "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n"
             "<meta name=\"viewport\" content=\"width=device-width\">\n"
             "<meta http-equiv=\"Content-Security-Policy\" "
             "content=\"{}\">\n<title>{}</title>\n<style>\n{}</style>\n{}{}",
             policy, html_text(title_text), kReportStyle, text_element("h1", title_text), body_html) +
         (plots ? fmt::format("<script nonce=\"{}\">\n{}</script>\n", nonce, kReportScript) : "") + "</html>\n";
}

}  // namespace opal
