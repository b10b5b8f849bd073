#pragma once

#include "benchmark/verdict/verdict.hpp"

namespace opal::statistics {

/// "better", "worse", "no difference of interest", "open".
std::string word_of(Outcome outcome);

/// What a metric is called: its name in words, without the unit: "first_fix_m" is "first fix"; a cost's phrase is a
/// name.
std::string name_in_words(const Metric& metric);

/// What it is called where it is said how an arm does: its phrase, else made of the name.
std::string phrase_of(const Metric& metric);

/// A share, distance or cost of one arm: "96.1 %", "0.40 m", "never".
std::string value_text(const Metric& metric, double value);

/// How far apart, without the direction: "3.8 points", "0.4 m", "12 %".
std::string distance_text(const Metric& metric, double size);

/// "95 %", of an interval at a level of 0.05.
std::string coverage_text(double level);

/// "95 % interval 1.2 to 6.5", in the direction in which the size is said.
std::string interval_text(const MetricResult& result, double level);

/// "difference 3.8 points", "median difference 0.4 m sooner", "12 % more".
std::string size_text(const MetricResult& result);

/// The same for a column of numbers, more than 0 where the arm has more: "-3.8 points", "-0.42 m", "12 %", "2.5 times".
std::string signed_size_text(const MetricResult& result);

/// Its interval with the same signs, without the unit: "-6.5 to -1.2".
std::string signed_interval_text(const MetricResult& result);

/// "about 140 more queries, from 10 more sites like these,"; two digits.
std::string more_queries_text(const MetricResult& result);

/// "a", "a and b", "a, b and c".
std::string list_text(const std::vector<std::string>& names);

}  // namespace opal::statistics
