"""A scorer in Python: how near the scan's returns are to what is mapped (Thrun, Burgard and Fox 2005, 6.4)."""

import numpy as np


class Likelihood:
    def __init__(self, weight=1.5, sigma_m=0.15):
        self.weight, self.sigma_m = weight, sigma_m

    def score(self, hypotheses, observation, map):
        if len(observation.points) == 0:
            return np.zeros(len(hypotheses))
        off = map.clearance(observation.points_at(hypotheses.poses)) / self.sigma_m
        return self.weight * np.log(0.4 + 8 * np.exp(-0.5 * off**2)).mean(axis=1)
