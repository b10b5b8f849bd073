#include "viewer/html/page.hpp"

#include "report/html_text.hpp"
#include "report/page_template.hpp"
#include "viewer/html/page_assets.hpp"

namespace opal {
namespace {

std::string page_with(const std::string& data) { return filled_page({kPageIndex, kPageStyle, kPageScript}, data); }

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
