"""Plugins that are classes of Python: what they are given, and how the plugin `python` finds and checks them.

A scorer has `score(self, hypotheses, observation, map)`. One that remembers also has `new_memory(self, map)`,
`remember(self, memory, seen, weight)` and perhaps `fade(self, memory, weight)`. A detector has `detect(self, scan)` and
`produces`, a pattern template `match(self, features)`, `slots`, `reach_m` and `consumes`. Arguments of the class are its
options. docs/python.md has examples; opal.examples has one class of each kind.
"""

from __future__ import annotations

import importlib
import importlib.machinery
import importlib.util
import json
import sys
import threading
import traceback
from dataclasses import dataclass
from pathlib import Path
from types import CodeType, ModuleType, TracebackType
from typing import Any, Dict, List, Optional, Tuple

import numpy as np
import numpy.typing as npt

from ._opal import Feature, Pattern

Doubles = npt.NDArray[np.float64]
Ints = npt.NDArray[np.int32]
SHAPES = ("point", "oriented_point", "segment", "circle")
_loading = threading.RLock()  # a file may load another one; a thread that comes second waits until the whole file has run


@dataclass(frozen=True)
class Hypotheses:
    """Places where the robot may be; all of them are judged by one observation."""

    poses: Doubles  #: of the robot in the map, now; shape (H, 3): x, y [m], heading [rad]
    T_map_local: Doubles  #: where the local map lies in the map; shape (H, 3)
    associations: List[Ints]  #: (local feature, feature of the map or -1) of each; empty unless judges_associations
    memories: List[Any]  #: what the scorer remembers of each, to be read only; empty unless it has new_memory

    def __len__(self) -> int:
        return len(self.poses)


@dataclass(frozen=True)
class Observation:
    """What the robot sees now, with all its lasers, in its own frame base_link."""

    points: Doubles  #: returns, thinned evenly in space [m]; shape (N, 2)
    scan_of_point: Ints  #: which scan each return is of; shape (N,)
    lasers: Doubles  #: where the beams of each scan start [m]; shape (S, 2)
    free_bearings_rad: List[Doubles]  #: of each scan: beams that returned nothing up to range_max_m
    range_max_m: List[float]  #: of each scan
    features: List[Feature]  #: of the newest scans

    def points_at(self, poses: Doubles) -> Doubles:
        """The returns in the map, for each pose of the robot: shape (H, 3) in, (H, N, 2) out."""
        cos, sin = np.cos(poses[:, 2:]), np.sin(poses[:, 2:])
        x, y = self.points[:, 0], self.points[:, 1]
        return np.stack([poses[:, :1] + cos * x - sin * y, poses[:, 1:2] + sin * x + cos * y], axis=-1)


def load(file: str) -> ModuleType:
    """The module of a file; the same one whenever it is asked for in this process. Its folder joins sys.path."""
    path = Path(file).resolve()
    name = f"opal_file_{path.stem}_{abs(hash(str(path))):x}"
    with _loading:
        return sys.modules[name] if name in sys.modules else _run(path, name)


class _AsWritten(importlib.machinery.SourceFileLoader):
    """Runs a file as it is, never what is cached beside it: that can be of something else."""

    def get_code(self, fullname: str) -> CodeType:
        code: CodeType = self.source_to_code(self.get_data(self.path), self.path)
        return code


def _run(path: Path, name: str) -> ModuleType:
    """The file runs as the module of that name; where it fails there is no such module."""
    spec = importlib.util.spec_from_file_location(name, path, loader=_AsWritten(name, str(path)))
    if spec is None or spec.loader is None:
        raise ImportError(f"{path}: no file of Python")
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module
    if str(path.parent) not in sys.path:
        sys.path.append(str(path.parent))
    try:
        spec.loader.exec_module(module)
    except BaseException:
        del sys.modules[name]
        raise
    return module


def find(source: str) -> Any:
    """The class that "FILE.py:CLASS" or "MODULE:CLASS" names."""
    place, _, name = source.rpartition(":")
    module = load(place) if place.endswith(".py") else importlib.import_module(place)
    if not hasattr(module, name):
        known = sorted(key for key, value in vars(module).items()
                       if isinstance(value, type) and value.__module__ == module.__name__)
        raise AttributeError(f"{place} has no class {name}; it has: {', '.join(known) or 'none'}")
    return getattr(module, name)


def make(source: str, options: str, method: str) -> Any:
    """An object of the class, with its options as arguments by name."""
    kind = {"score": "a scorer", "detect": "a detector", "match": "a pattern template"}[method]
    made = find(source)
    if not callable(getattr(made, method, None)):
        raise TypeError(f"{source} has no method {method}, expected {kind}")
    return made(**json.loads(options))


def told(error: BaseException, trace: Optional[TracebackType] = None) -> str:
    """'acme.py:17: ValueError: operands could not be broadcast': the last place of the error outside of Opal."""
    frames = [frame for frame in traceback.extract_tb(trace or error.__traceback__)
              if frame.filename != __file__ and not frame.filename.startswith("<frozen")]
    words = " ".join("".join(traceback.format_exception_only(type(error), error)).split("\n")).strip()
    if isinstance(error, SyntaxError):
        return f"{error.filename}:{error.lineno}: {type(error).__name__}: {error.msg}"
    return f"{frames[-1].filename}:{frames[-1].lineno}: {words}" if frames else words


def _numbers(given: Any, count: int, what: str) -> List[float]:
    numbers = np.asarray(given, dtype=float)
    if numbers.shape != (count,):
        raise ValueError(f"{what}: an array of shape {numbers.shape}, expected ({count},): a number per hypothesis")
    return numbers.tolist()  # type: ignore[no-any-return]


Scores = Tuple[List[float], Dict[str, List[float]], List[str], List[Any]]


def checked_scores(scorer: Any, said: Any, count: int) -> Scores:
    """What `score` may return: scores [nat]; or a tuple of them, a dict of what explains them, a list of vetoes, and a list
    of what each hypothesis has seen. The tuple may end earlier."""
    name = f"{type(scorer).__name__}.score"
    parts = said if isinstance(said, tuple) else (said,)
    nats, breakdown, vetoes, seen = (*parts, *({}, [], [])[len(parts) - 1:])[:4]
    scores = _numbers(nats, count, name)
    terms = {str(key): _numbers(values, count, f"{name}: {key}") for key, values in breakdown.items()}
    if vetoes and len(vetoes) != count:
        raise ValueError(f"{name}: {len(vetoes)} vetoes, expected {count}, empty where there is none")
    if seen is not None and len(seen) not in (0, count):
        raise ValueError(f"{name}: {len(seen)} things seen, expected {count}: one per hypothesis")
    return scores, terms or {"score": scores}, [str(veto or "") for veto in vetoes], list(seen or [])


def checked_features(detector: Any, found: Any) -> List[Feature]:
    """What `detect` may return: opal.Feature of the types that the class says it produces."""
    features = list(found)
    for feature in features:
        if not isinstance(feature, Feature):
            raise TypeError(f"{type(detector).__name__}.detect: found {type(feature).__name__}, expected opal.Feature")
    return features


def checked_shape(template: Any) -> Tuple[List[int], float, float]:
    """Slots as numbers, reach and reach of neighbours of a template."""
    slots = [SHAPES.index(slot) if slot in SHAPES else -1 for slot in template.slots]
    if -1 in slots:
        raise ValueError(f"{type(template).__name__}.slots: {list(template.slots)}, expected names of {', '.join(SHAPES)}")
    return slots, float(template.reach_m), float(getattr(template, "neighbour_reach_m", 0))


def checked_pattern(template: Any, found: Any) -> Pattern:
    """What `match` may return: opal.Pattern; without members they are in the order given."""
    if not isinstance(found, Pattern):
        raise TypeError(f"{type(template).__name__}.match: found {type(found).__name__}, expected opal.Pattern or None")
    if not found.members:
        found.members = list(range(len(template.slots)))
    return found
