#include "cli/bench/bench_splices.hpp"

namespace {

/// Gives the rows the stamps of the recording. @return the first row after the cut.
std::size_t restore_stamps(RunRecord& record, const opal::SplicedLog& log) {
  std::size_t sample = 0, rival = 0, first_after = record.rows.size();
  for (std::size_t row = 0; row < record.rows.size(); ++row) {
    double& stamp_s = record.rows[row].stamp_s;
    while (log.samples[sample].scan.stamp_s != stamp_s) ++sample;
    if (sample >= log.cut) first_after = std::min(first_after, row);
    for (; rival < record.rivals.size() && record.rivals[rival].stamp_s == stamp_s; ++rival)
      record.rivals[rival].stamp_s = log.recorded_s[sample];
    stamp_s = log.recorded_s[sample];
    ++sample;
  }
  return first_after;
}

}  // namespace

SplicedRuns run_splices(opal::Localizer& localizer, const BenchPlace& place, const opal::GroundTruth& truth,
                        const opal::SpliceOptions& options) {
  SplicedRuns runs;
  for (const opal::Splice& splice : opal::draw_splices(place.site.name, place.queries, truth, options)) {
    opal::Replay before = place.replay(splice.before), after = place.replay(splice.after);
    const opal::SplicedLog log = opal::spliced(opal::read_all(before), opal::read_all(after));
    localizer.reset();
    auto next = log.samples.begin();
    const SampleSource source = [&]() -> std::optional<opal::Sample> {
      if (next == log.samples.end()) return std::nullopt;
      return *next++;
    };
    RunRecord record = run_samples(localizer, place.deployment.laser, source, splice.id);
    const std::size_t cut = restore_stamps(record, log);
    opal::KidnappingVerdict verdict = opal::judge_kidnapping(record.rows, cut, truth);
    verdict.id = splice.id;
    verdict.apart_m = splice.apart_m;
    runs.verdicts.push_back(verdict);
    runs.all.append(record);
  }
  return runs;
}
