"""Pictures with matplotlib, which is imported when something is drawn. All coordinates are in the map frame [m]."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional

import numpy as np

if TYPE_CHECKING:
    from . import Estimate, Localizer, Map, Run, Scan


def axes() -> Any:
    """New axes with equal scales, in a figure of their own."""
    from matplotlib import pyplot

    figure, made = pyplot.subplots()
    made.set_aspect("equal")
    made.set_xlabel("x [m]")
    made.set_ylabel("y [m]")
    return made


def moved(pose: Any, points: Any) -> Any:
    """Points of shape (N, 2) from the frame that stands at `pose` (x, y, heading) to the frame of the pose."""
    x, y, heading = np.asarray(pose, dtype=float)
    cos, sin = np.cos(heading), np.sin(heading)
    return np.asarray(points, dtype=float).reshape(-1, 2) @ np.array([[cos, sin], [-sin, cos]]) + (x, y)


def draw_map(map: Map, ax: Optional[Any] = None, **style: Any) -> Any:
    """Faces as lines, circles as circles, corners and points as dots. Returns the axes."""
    from matplotlib.collections import LineCollection
    from matplotlib.patches import Circle

    ax = axes() if ax is None else ax
    color = style.pop("color", "0.3")
    ax.add_collection(LineCollection(map.segments().reshape(-1, 2, 2), colors=color, linewidths=style.pop("linewidth", 1)))
    for x, y, radius in map.circles():
        ax.add_patch(Circle((x, y), radius, fill=False, color=color))
    dots = np.concatenate([map.points(), map.corners()[:, :2]])
    ax.plot(dots[:, 0], dots[:, 1], ".", color=color, markersize=2)
    ax.autoscale_view()
    return ax


def draw_scan(scan: Scan, pose: Any, ax: Optional[Any] = None, mount: Any = (0.0, 0.0, 0.0), **style: Any) -> Any:
    """The hits of a scan. pose: of the robot in the map; mount: of the laser on the robot. Returns the axes."""
    ax = axes() if ax is None else ax
    points = moved(pose, moved(mount, scan.points))
    ax.plot(points[:, 0], points[:, 1], ".", **{"color": "tab:red", "markersize": 2, **style})
    return ax


def draw_pose(pose: Any, ax: Optional[Any] = None, length_m: float = 1.0, **style: Any) -> Any:
    """An arrow from the robot along its heading. Returns the axes."""
    ax = axes() if ax is None else ax
    x, y, heading = pose
    ends = {"xytext": (x, y), "xy": (x + length_m * np.cos(heading), y + length_m * np.sin(heading))}
    ax.annotate("", **ends, arrowprops={"arrowstyle": "->", "color": "tab:blue", "linewidth": 2, **style})
    ax.plot([x], [y], "o", color=style.get("color", "tab:blue"), markersize=4)
    return ax


def draw_run(run: Run, ax: Optional[Any] = None, **style: Any) -> Any:
    """The way of the robot. Returns the axes."""
    ax = axes() if ax is None else ax
    way = run.trajectory
    ax.plot(way[:, 1], way[:, 2], **{"color": "tab:blue", "linewidth": 1, **style})
    return ax


def draw_answer(localizer: Localizer, estimate: Estimate, scan: Optional[Scan] = None, ax: Optional[Any] = None) -> Any:
    """Map, scan, pose, other places and associations, with the status as the title. Returns the axes."""
    ax = draw_map(localizer.map, ax)
    for other in estimate.alternatives:
        draw_pose(other.pose, ax, color="0.6")
    for pair in localizer.associations:
        if pair.shape == "segment":
            x0, y0, x1, y1 = pair.mapped
            ax.plot([x0, x1], [y0, y1], color="tab:green", linewidth=3, alpha=0.5)
        else:
            ax.plot([pair.mapped[0]], [pair.mapped[1]], "o", color="tab:green", alpha=0.5)
    if estimate.pose is not None:
        if scan is not None:
            draw_scan(scan, estimate.pose, ax, mount=localizer.deployment.lasers[0].mount)
        draw_pose(estimate.pose, ax)
    ax.set_title(f"{estimate.status}, probability {estimate.probability:.3f}")
    return ax
