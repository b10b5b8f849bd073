#include "viewer/html/page.hpp"

#include "report/html_elements.hpp"
#include "report/html_text.hpp"
#include "viewer/html/page_assets.hpp"

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

std::string page_with(const std::string& data) {
  const std::string nonce = inline_nonce({data, kPageStyle, kPageScript}),
                    open_style = "<style nonce=\"" + nonce + "\">\n",
                    open_script = "<script nonce=\"" + nonce + "\">\n";
  return fill_in(kPageIndex, {{"style", policy(nonce) + open_style + std::string(kPageStyle) + "</style>"},
                              {"data", data},
                              {"script", open_script + std::string(kPageScript) + "</script>"}});
}

}  // namespace

std::size_t room_for_data(std::size_t runs) {
  constexpr std::size_t kMarkup = 10'000;
  return (kLargestPage - kPageIndex.size() - kPageStyle.size() - kPageScript.size() - kMarkup) / runs;
}

std::string page_of(const std::vector<PackedRun>& runs) {
  std::string data;
  for (const PackedRun& run : runs)
    data += "<script type=\"text/plain\" class=\"opal-run\" data-name=\"" + html_text(run.name) + "\">" + run.data +
            "</script>\n";
  return page_with(data);
}

std::string live_page(const std::string& events_path) {
  return page_with("<meta name=\"opal-live\" content=\"" + html_text(events_path) + "\">\n");
}

}  // namespace opal
