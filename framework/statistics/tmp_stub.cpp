#include "statistics/comparison.hpp"
#include "statistics/report_page.hpp"
namespace opal::statistics {
std::vector<Verdict> compare(const ResultsTable&, const ComparisonOptions&) { return {}; }
std::string to_html(const ReportPage&) { return ""; }
}
