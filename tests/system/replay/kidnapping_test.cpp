#include "recorded_site.hpp"

#include "evaluation/kidnapping.hpp"
#include "evaluation/kidnapping_sequence.hpp"

#include <catch2/catch.hpp>

using namespace opal;

namespace {

/// The first stretch of the recording, and then the last one, joined.
KidnappingLog kidnapped(const RecordedSite& site) {
  const std::span<const Sample> all(site.samples);
  return with_kidnapping(all.first(all.size() * 45 / 100), all.last(all.size() * 40 / 100));
}

struct Run {
  std::vector<ResultRow> rows;
  std::size_t cut = 0;
};

Run run_kidnapping(const RecordedSite& site) {
  const KidnappingLog log = kidnapped(site);
  Localizer localizer(site.parts());
  Run run;
  const auto replayed = replay(localizer, log.samples);
  for (std::size_t k = 0; k < replayed.size(); ++k) {
    const PoseEstimate& said = replayed[k].estimate;
    if (k == log.cut) run.cut = run.rows.size();
    if (said.has_pose)
      run.rows.push_back(
          {"", log.recorded_s[k], said.T_map_base * site.laser.T_base_laser, said.status, said.probability, said.none});
  }
  return run;
}

}  // namespace

TEST_CASE("a robot that is kidnapped says so before it says anything wrong, and finds itself again") {
  const RecordedSite site("malaga");
  const Run run = run_kidnapping(site);
  const KidnappingVerdict verdict = judge_kidnapping(run.rows, run.cut, site.truth);
  CHECK(verdict.localized_before);
  CHECK(verdict.honest());
  CHECK(verdict.lost_after_m);
  CHECK(verdict.recovered);
  CHECK(verdict.right_after_m.value_or(8) < 8);
}

TEST_CASE("a probability, its alternatives' and that of none of them never add up to more than one") {
  const RecordedSite site("malaga");
  const KidnappingLog log = kidnapped(site);
  Localizer localizer(site.parts());
  double most_none = 0;
  for (const ReplayedScan& scan : replay(localizer, log.samples)) {
    double sum = scan.estimate.probability + scan.estimate.none;
    for (const auto& alternative : scan.estimate.alternatives) sum += alternative.probability;
    CHECK(sum <= 1 + 1e-9);
    CHECK(sum > 0.8);  // alternatives below one percent are not listed
    if (scan.estimate.has_pose) most_none = std::max(most_none, scan.estimate.none);
  }
  CHECK(most_none > 0.5);  // right after the cut
}
