#pragma once

#include <experiments/contender.hpp>

#include <vector>

/// Who takes part in an experiment: names of shipped configurations, or files (.jsonld), which are called by their stem.
std::vector<opal::experiments::Contender> read_contenders(const std::vector<std::string>& configs);
