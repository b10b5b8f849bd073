#pragma once

#include "viewer/words/explanation.hpp"

#include <initializer_list>
#include <string>
#include <vector>

/// A hall with a wall along y = 0 and two columns, and frames made by hand in it.
opal::RunHeader hall();
inline constexpr opal::MapFeatureNumber kWallFace{0}, kColumnA{1}, kColumnB{2};

/// A frame in which everything is where it was: a local map that coincides with the map.
opal::RunFrame frame_at(double time_s, const std::string& status, double probability, double none);

opal::RecordedHypothesis hypothesis(int id, const opal::Pose2& T_map_base, double probability, double nat,
                                    std::vector<opal::RecordedTerm> scores = {});

/// The frame's hypotheses; the first one is the best.
opal::RunFrame with(opal::RunFrame frame, std::vector<opal::RecordedHypothesis> hypotheses);

/// What is said of one kind, one line each, after all frames.
std::vector<std::string> sentences_of(opal::SentenceKind kind, const std::vector<opal::RunFrame>& frames);
