#include "viewer/page_detail.hpp"

namespace opal {

std::span<const PageDetail> page_details() {
  static const std::vector<PageDetail> kDetails{
      {},
      {.unit_m = 0.005, .unit_rad = 0.002, .unit_nat = 0.05, .scan_unit_m = 0.01,
       .reduced = {"Hypotheses are shown in steps of 5 mm and 2 mrad, scans in steps of 1 cm."}},
      {.unit_m = 0.01, .unit_rad = 0.005, .unit_nat = 0.1, .scan_unit_m = 0.02, .scan_stride = 2, .most_scores = 3,
       .reduced = {"Hypotheses are shown in steps of 1 cm and 5 mrad, scans in steps of 2 cm.",
                   "Every second point of the scans is left out.", "Scores are those of the best three hypotheses."}},
      {.unit_m = 0.02, .unit_rad = 0.01, .unit_nat = 0.2, .scan_unit_m = 0.02, .scan_stride = 3, .most_scores = 1,
       .reduced = {"Hypotheses are shown in steps of 2 cm and 10 mrad, scans in steps of 2 cm.",
                   "Two of three points of the scans are left out.", "Scores are those of the best hypothesis."}},
      {.unit_m = 0.02, .unit_rad = 0.01, .unit_nat = 0.2, .scan_unit_m = 0.05, .scan_stride = 6, .most_scores = 1,
       .most_hypotheses = 60,
       .reduced = {"Hypotheses are shown in steps of 2 cm and 10 mrad, scans in steps of 5 cm.",
                   "Five of six points of the scans are left out.", "Scores are those of the best hypothesis.",
                   "Only the 60 most likely hypotheses of each update are shown."}},
      {.unit_m = 0.02, .unit_rad = 0.01, .unit_nat = 0.2, .scan_unit_m = 0.05, .scan_stride = 0, .most_scores = 1,
       .most_hypotheses = 15,
       .reduced = {"Hypotheses are shown in steps of 2 cm and 10 mrad.", "Scans are left out.",
                   "Scores are those of the best hypothesis.",
                   "Only the 15 most likely hypotheses of each update are shown."}}};
  return kDetails;
}

}  // namespace opal
