#pragma once

#include <cstdint>
#include <random>

namespace opal::simulation {

/// Nothing in a building differs by less [cm].
inline constexpr int kGrid_cm = 5;

/// A length on that grid, rounded towards zero [cm].
constexpr int rounded_to_grid(int length_cm) { return length_cm / kGrid_cm * kGrid_cm; }

/// Draws what differs between parts of a building. The same seed gives the same numbers everywhere: the generator is
/// standardized, and the distributions are our own.
class Variation {
 public:
  /// @param symmetry  0: everything is drawn; 1: everything is as usual.
  Variation(std::uint64_t seed, double symmetry) : random_(seed), symmetry_(symmetry) {}

  bool chance(double probability) { return 0x1p-53 * static_cast<double>(random_() >> 11) < probability; }
  /// low, low + kGrid_cm, ... up to high [cm].
  int between(int low, int high) {
    if (high <= low) return low;
    return low + kGrid_cm * static_cast<int>(random_() % static_cast<std::uint64_t>((high - low) / kGrid_cm + 1));
  }

  /// Whether a part is as usual; it is drawn if not.
  bool is_usual() { return chance(symmetry_); }
  /// The usual length, or any other [cm].
  int length(int usual, int low, int high) { return is_usual() ? usual : between(low, high); }
  bool yes(bool usual, double probability) { return is_usual() ? usual : chance(probability); }

 private:
  std::mt19937_64 random_;
  double symmetry_;
};

}  // namespace opal::simulation
