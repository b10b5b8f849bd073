"""Opal: where is a wheeled robot in a building? Maps, recorded and simulated logs, the localizer step by step, benches, results
of experiments.

Units are metres, radians and seconds. A pose is an array of x [m], y [m] and heading [rad]. Frames: `map` is fixed to the
building, `odom` to the start of odometry, the robot's frame is `base_link`. Every wrong input raises an opal.Error that
names file, place, what was found and what was expected.
"""

from ._opal import (
    Alternative as Alternative,
    Association as Association,
    Bench as Bench,
    ConfigError as ConfigError,
    Deployment as Deployment,
    Error as Error,
    Estimate as Estimate,
    EventError as EventError,
    EventReader as EventReader,
    Feature as Feature,
    Hypothesis as Hypothesis,
    JsonError as JsonError,
    Laser as Laser,
    Localizer as Localizer,
    Log as Log,
    LogError as LogError,
    Map as Map,
    MapError as MapError,
    MapFeature as MapFeature,
    MapObject as MapObject,
    MapPattern as MapPattern,
    MapView as MapView,
    Pattern as Pattern,
    Place as Place,
    PluginError as PluginError,
    PluginType as PluginType,
    RawScan as RawScan,
    Replay as Replay,
    Run as Run,
    Sample as Sample,
    Scan as Scan,
    View as View,
    WriteError as WriteError,
    add_plugins as add_plugins,
    bench as bench,
    check_class as check_class,
    generate_building as generate_building,
    make_deployment as make_deployment,
    plugins as plugins,
    read_deployment as read_deployment,
    read_events as read_events,
    read_laser as read_laser,
    read_log as read_log,
    read_map as read_map,
    shipped_file as shipped_file,
    simulate as simulate,
)
from .ab import AbResults as AbResults, read_ab as read_ab

__all__ = sorted(name for name in globals() if not name.startswith("_"))
