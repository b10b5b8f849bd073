#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace opal {

/// Random numbers that are the same everywhere for the same seed: the generator is given by the standard, and the
/// distributions, which are not, are written out here.
class Random {
 public:
  explicit Random(std::uint64_t seed) : bits_(seed) {}

  /// In [0, 1).
  double share() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }
  double uniform(double from, double to) { return from + (to - from) * share(); }
  bool chance(double probability) { return share() < probability; }
  /// In [0, count); count must be positive.
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(share() * static_cast<double>(count)); }
  /// Gaussian about 0 (Box and Muller 1958).
  double normal(double sigma) {
    const double radius = std::sqrt(-2 * std::log(1 - share()));
    return sigma * radius * std::cos(2 * std::numbers::pi * share());
  }
  /// A stream of its own, so that what is drawn there changes nothing here.
  Random branch() { return Random(bits_()); }

 private:
  std::mt19937_64 bits_;
};

}  // namespace opal
