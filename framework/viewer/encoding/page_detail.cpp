#include "viewer/encoding/page_detail.hpp"

namespace opal {
namespace {

constexpr int kAll = 1'000'000;

}  // namespace

std::span<const PageDetail> page_details() {
  static const std::string kFine = "Hypotheses are shown in steps of 5 mm and 2 mrad, scans in steps of 1 cm.";
  static const std::string kCoarse = "Hypotheses are shown in steps of 1 cm and 5 mrad, scans in steps of 2 cm.";
  static const std::string kCoarser = "Hypotheses are shown in steps of 2 cm and 10 mrad, scans in steps of 2 cm.";
  static const std::string kCoarsest = "Hypotheses are shown in steps of 5 cm and 20 mrad, scans in steps of 5 cm.";
  static const std::string kScores = "Scores are those of the best hypothesis.";
  static const std::vector<PageDetail> kDetails{
      {},
      {0.005, 0.002, 0.05, 0.01, 1, 5, kAll, {kFine}},
      {0.01, 0.005, 0.1, 0.02, 1, 3, kAll, {kCoarse, "Scores are those of the best three hypotheses."}},
      {0.02, 0.01, 0.2, 0.02, 2, 1, kAll, {kCoarser, "Every second point of the scans is left out.", kScores}},
      {0.05, 0.02, 0.5, 0.05, 4, 1, kAll, {kCoarsest, "Three of four points of the scans are left out.", kScores}},
      {0.05,
       0.02,
       0.5,
       0.05,
       6,
       1,
       60,
       {kCoarsest, "Five of six points of the scans are left out.", kScores,
        "Only the 60 most likely hypotheses of each update are shown."}},
      {0.05,
       0.02,
       0.5,
       0.05,
       0,
       1,
       15,
       {kCoarsest, "Scans are left out.", kScores, "Only the 15 most likely hypotheses of each update are shown."}}};
  return kDetails;
}

}  // namespace opal
