"""One plugin of each kind, as short as can be. The plugin `python` runs them where nothing else is named."""

from __future__ import annotations

from typing import Any, List, Optional

import numpy as np

from ._opal import Feature, MapView, Pattern, Scan
from .plugin import Hypotheses, Observation


class Likelihood:
    """A scorer: how near returns are to what is mapped (Thrun, Burgard and Fox 2005, 6.4)."""

    def __init__(self, weight: float = 1.5, sigma_m: float = 0.15, hit_share: float = 0.6) -> None:
        self.weight, self.sigma_m, self.hit_share = weight, sigma_m, hit_share

    def score(self, hypotheses: Hypotheses, observation: Observation, map: MapView) -> Any:
        if len(observation.points) == 0:
            return np.zeros(len(hypotheses))
        off = map.clearance(observation.points_at(hypotheses.poses)) / self.sigma_m
        peak = map.clearance_cap_m * 2 / (self.sigma_m * np.sqrt(2 * np.pi))
        ratio = 1 - self.hit_share + self.hit_share * peak * np.exp(-0.5 * off**2)
        return self.weight * np.log(ratio).mean(axis=1)


class NoFeatures:
    """A detector that finds nothing."""

    produces: List[str] = []

    def detect(self, scan: Scan) -> List[Feature]:
        return []


class CirclePair:
    """A pattern template: two circles at a distance; the larger one goes first."""

    consumes: List[str] = []
    slots = ["circle", "circle"]

    def __init__(self, reach_m: float = 8.0, min_distance_m: float = 0.5, tolerance_m: float = 0.2) -> None:
        self.reach_m, self.min_distance_m, self.tolerance_m = reach_m, min_distance_m, tolerance_m

    def match(self, features: List[Feature]) -> Optional[Pattern]:
        (ax, ay, a), (bx, by, b) = (feature.numbers for feature in features)
        distance = float(np.hypot(bx - ax, by - ay))
        if not distance >= self.min_distance_m or not (a, ax, ay) > (b, bx, by):
            return None
        frame = [(ax + bx) / 2, (ay + by) / 2, np.arctan2(by - ay, bx - ax)]
        radii = [(a, self.tolerance_m), (b, self.tolerance_m)]
        return Pattern([(distance, self.tolerance_m), *radii], frame, symmetric=bool(a - b < self.tolerance_m))
