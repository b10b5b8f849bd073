#include "cli/bench/bench_kidnappings.hpp"

namespace opal::cli {
namespace {

/// Gives the rows the stamps of the recording. @return the first row after the cut.
std::size_t restore_stamps(benchmark::RunRecord& record, const KidnappingLog& log) {
  std::size_t sample = 0, alternative = 0, first_after = record.rows.size();
  for (std::size_t row = 0; row < record.rows.size(); ++row) {
    double& stamp_s = record.rows[row].stamp_s;
    while (log.samples.at(sample).stamp_s != stamp_s) ++sample;
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

KidnappingRuns run_kidnappings(Localizer& localizer, const benchmark::BenchPlace& place, const GroundTruth& truth,
                               const KidnappingSequenceOptions& options, const std::stop_token& stop) {
  KidnappingRuns runs;
  for (const KidnappingSequence& sequence : draw_kidnapping_sequences(place.site.name, place.queries, truth, options)) {
    Replay before = place.replay(sequence.before), after = place.replay(sequence.after);
    const KidnappingLog log = with_kidnapping(read_all(before), read_all(after));
    localizer.reset();
    auto next = log.samples.begin();
    const benchmark::SampleSource source = [&]() -> std::optional<Sample> {
      if (next == log.samples.end()) return std::nullopt;
      return *next++;
    };
    const benchmark::RunObserver observer{[&](double) { return !stop.stop_requested(); }, {}, {}};
    benchmark::RunRecord record =
        benchmark::run_samples(localizer, place.deployment.lasers.front(), source, sequence.id, observer);
    runs.is_cut = stop.stop_requested();
    if (runs.is_cut) break;
    const std::size_t cut = restore_stamps(record, log);
    KidnappingVerdict verdict = judge_kidnapping(record.rows, cut, truth);
    verdict.id = sequence.id;
    verdict.apart_m = sequence.apart_m;
    runs.verdicts.push_back(verdict);
    runs.all.append(record);
  }
  return runs;
}

}  // namespace opal::cli
