#pragma once

#include "benchmark/verdict/verdict.hpp"

namespace opal::statistics {

/// "B localizes in 96.1 % against 92.3 % (difference 3.8 points, 95 % interval 1.2 to 6.5), median 0.4 m sooner (...),
/// 12 % more CPU
/// (...); better on acapulco and csail, no difference told elsewhere. No verdict yet on ...: about 140 more queries
/// would tell ...". What has been told comes first, then what need not be expected, then what is open.
std::string sentence_of(const Verdict& verdict);

/// What one must know beside it: looks, failures, pairs without a value, distances never reached, and where tests of
/// pairs and of clusters disagree.
std::vector<std::string> notes_of(const Verdict& verdict);

}  // namespace opal::statistics
