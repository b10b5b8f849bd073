#pragma once

#include "map_tools/test_maps/map_damage.hpp"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

namespace opal::cli {

/// The options of every verb that makes a map worse.
struct DamageOptions {
  std::string words;
  double plan_m = 0;
  std::uint64_t seed = 1;

  void add_to(CLI::App& verb) {
    verb.add_option("--plan", plan_m, "delete every mapped segment shorter than this [m]: what a plan would hold");
    verb.add_option("--damage", words,
                    "thick=METRES,drop=SHARE,shift=METRES,wall=METRES,wall_share=SHARE,false=SHARE, any of them; "
                    "thick= is done to a grid before it is imported");
    verb.add_option("--seed", seed, "of the damage: the same seed gives the same map")->capture_default_str();
  }

  /// Whether any was asked for.
  bool any() const { return plan_m > 0 || !words.empty(); }

  /// @throws opal::ConfigError if the words make no sense.
  MapDamage damage() const {
    MapDamage damage = read_map_damage(words);
    if (plan_m > 0) damage.plan_m = plan_m;
    damage.seed = seed;
    return damage;
  }

  /// Nothing unless any was asked for.
  std::optional<MapDamage> asked() const { return any() ? std::optional(damage()) : std::nullopt; }
};

}  // namespace opal::cli
