#include "report/page_template.hpp"

#include "report/html_elements.hpp"

#include <map>

namespace opal {
namespace {

std::string policy(const std::string& nonce) {
  return "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'nonce-" + nonce +
         "'; script-src 'nonce-" + nonce +
         "'; connect-src 'self'; img-src data: blob:; base-uri 'none'; form-action 'none'\">\n";
}

/// The template with a text in the place of each mark `<!-- opal:NAME -->`.
std::string fill_in(std::string_view html, const std::map<std::string_view, std::string>& texts) {
  constexpr std::string_view kBegin = "<!-- opal:", kEnd = " -->";
  std::string page;
  while (true) {
    const std::size_t begin = html.find(kBegin);
    page.append(html.substr(0, begin));
    if (begin == std::string_view::npos) return page;
    html.remove_prefix(begin + kBegin.size());
    const std::size_t end = html.find(kEnd);
    page.append(texts.at(html.substr(0, end)));
    html.remove_prefix(end + kEnd.size());
  }
}

}  // namespace

std::string filled_page(const PageTemplate& page, const std::string& data) {
  const std::string nonce = inline_nonce({data, page.style, page.script}),
                    open_style = "<style nonce=\"" + nonce + "\">\n",
                    open_script = "<script nonce=\"" + nonce + "\">\n";
  return fill_in(page.index, {{"style", policy(nonce) + open_style + std::string(page.style) + "</style>"},
                              {"data", data},
                              {"script", open_script + std::string(page.script) + "</script>"}});
}

std::string json_in_html(const nlohmann::ordered_json& json) {
  const std::string plain = json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  std::string text;
  for (std::size_t k = 0; k < plain.size(); ++k) {
    const bool escape = plain[k] == '\\';
    const char c = escape ? plain[++k] : plain[k];
    if (c == '<' || (escape && c == '"'))
      text += c == '<' ? "\\u003c" : "\\u0022";
    else
      text += escape ? std::string{'\\', c} : std::string(1, c);
  }
  return text;
}

}  // namespace opal
