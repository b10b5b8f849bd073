#include "statistics/report_page.hpp"
namespace opal::statistics {
std::string to_html(const ReportPage&) { return ""; }
}
