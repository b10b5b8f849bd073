"""Results of A/B experiments: what `opal ab` has left in a folder, as columns and frames."""

from __future__ import annotations

import json
import pathlib
from typing import Any, Dict, List

from ._opal import Error


class AbResults:
    """A finished experiment of `opal ab`. Made by read_ab()."""

    def __init__(self, folder: str) -> None:
        self.folder = folder
        self.manifest: Dict[str, Any] = _read_json(folder, "manifest.json")
        self.verdicts: List[Dict[str, Any]] = _read_json(folder, "verdict.json")
        self._results, self._times = _read_lines(folder, "results.jsonl"), _read_lines(folder, "times.jsonl")

    @property
    def sentences(self) -> List[str]:
        """The verdict in words, one sentence per arm that is compared with the baseline."""
        return [str(verdict["sentence"]) for verdict in self.verdicts]

    def columns(self) -> Dict[str, List[Any]]:
        """A row per cell: scenario, query, seed, arm, failure (empty: it ran), then every value and measured cost by the
        name of its metric (docs/compare_scorers.md has the units). None: never reached, or not known."""
        costs = {str(line["cell"]): line["costs"] for line in self._times}
        rows = [{**line["values"], **costs.get(str(line["cell"]), {})} for line in self._results]
        names = sorted({name for row in rows for name in row})
        heads = {key: [line[key] for line in self._results] for key in ("scenario", "query", "seed", "arm", "failure")}
        return {**heads, **{name: [row.get(name) for row in rows] for name in names}}

    def frame(self) -> Any:
        """The same as a pandas.DataFrame; needs pandas."""
        return _data_frame(self.columns())

    def verdict_columns(self) -> Dict[str, List[Any]]:
        """A row per arm and metric: arm, baseline, metric, the value of each, their difference, its interval, p, p
        corrected after Holm, pairs, outcome."""
        rows = [_verdict_row(verdict, metric) for verdict in self.verdicts for metric in verdict["metrics"]]
        return {name: [row[name] for row in rows] for name in _verdict_row({}, {})}

    def verdict_frame(self) -> Any:
        """The same as a pandas.DataFrame; needs pandas."""
        return _data_frame(self.verdict_columns())

    def __repr__(self) -> str:
        return f"<opal.AbResults {self.folder}: {len(self._results)} cells>"


def read_ab(folder: str) -> AbResults:
    """Reads the folder of a finished `opal ab`. Raises opal.Error that names the file if it is not one."""
    return AbResults(str(folder))


def _verdict_row(verdict: Dict[str, Any], metric: Dict[str, Any]) -> Dict[str, Any]:
    low, high = metric.get("interval", (None, None))
    return {"arm": verdict.get("arm"), "baseline": verdict.get("baseline"), "metric": metric.get("metric"),
            "value": metric.get("arm"), "value_of_baseline": metric.get("baseline"),
            "difference": metric.get("difference"), "low": low, "high": high, "p": metric.get("p"),
            "p_corrected": metric.get("p_corrected"), "pairs": metric.get("pairs"), "outcome": metric.get("outcome")}


def _read_text(folder: str, name: str) -> str:
    path = pathlib.Path(folder) / name
    try:
        return path.read_text(encoding="utf-8")
    except OSError as error:
        raise Error(f"{path}: cannot be read ({error.strerror}), expected the folder of a finished opal ab") from error


def _parse(text: str, place: str) -> Any:
    try:
        return json.loads(text)
    except ValueError as error:
        raise Error(f"{place}: is no JSON: {error}") from error


def _read_json(folder: str, name: str) -> Any:
    return _parse(_read_text(folder, name), f"{folder}/{name}")


def _read_lines(folder: str, name: str) -> List[Dict[str, Any]]:
    lines = _read_text(folder, name).removesuffix("\n").split("\n")  # names may have other ends of lines
    return [_parse(line, f"{folder}/{name}: line {number}") for number, line in enumerate(lines, 1)]


def _data_frame(columns: Dict[str, List[Any]]) -> Any:
    import pandas

    return pandas.DataFrame(columns)
