#include "cli/bench/bench_kidnappings.hpp"

namespace {

/// Gives the rows the stamps of the recording. @return the first row after the cut.
std::size_t restore_stamps(opal::benchmark::RunRecord& record, const opal::KidnappingLog& log) {
  std::size_t sample = 0, alternative = 0, first_after = record.rows.size();
  for (std::size_t row = 0; row < record.rows.size(); ++row) {
    double& stamp_s = record.rows[row].stamp_s;
    while (log.samples[sample].views.front().scan.stamp_s != stamp_s) ++sample;
    if (sample >= log.cut) first_after = std::min(first_after, row);
    for (; alternative < record.alternatives.size() && record.alternatives[alternative].stamp_s == stamp_s;
         ++alternative)
      record.alternatives[alternative].stamp_s = log.recorded_s[sample];
    stamp_s = log.recorded_s[sample];
    ++sample;
  }
  return first_after;
}

}  // namespace

KidnappingRuns run_kidnappings(opal::Localizer& localizer, const opal::benchmark::BenchPlace& place,
                               const opal::GroundTruth& truth, const opal::KidnappingSequenceOptions& options,
                               const std::stop_token& stop) {
  KidnappingRuns runs;
  for (const opal::KidnappingSequence& sequence :
       opal::draw_kidnapping_sequences(place.site.name, place.queries, truth, options)) {
    opal::Replay before = place.replay(sequence.before), after = place.replay(sequence.after);
    const opal::KidnappingLog log = opal::with_kidnapping(opal::read_all(before), opal::read_all(after));
    localizer.reset();
    auto next = log.samples.begin();
    const opal::benchmark::SampleSource source = [&]() -> std::optional<opal::Sample> {
      if (next == log.samples.end()) return std::nullopt;
      return *next++;
    };
    const opal::benchmark::RunObserver observer{[&](double) { return !stop.stop_requested(); }, {}, {}};
    opal::benchmark::RunRecord record =
        opal::benchmark::run_samples(localizer, place.deployment.lasers.front(), source, sequence.id, observer);
    runs.is_cut = stop.stop_requested();
    if (runs.is_cut) break;
    const std::size_t cut = restore_stamps(record, log);
    opal::KidnappingVerdict verdict = opal::judge_kidnapping(record.rows, cut, truth);
    verdict.id = sequence.id;
    verdict.apart_m = sequence.apart_m;
    runs.verdicts.push_back(verdict);
    runs.all.append(record);
  }
  return runs;
}
