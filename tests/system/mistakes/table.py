"""All mistakes, by group; a group is a test of ctest."""

import table_commands
import table_files
import table_logs
import table_maps
import table_output
import table_sensor

GROUPS = {
    "commands": ("The command", table_commands.MISTAKES),
    "files": ("The files that are named", table_files.MISTAKES),
    "maps": ("The map", table_maps.MISTAKES),
    "logs": ("The log", table_logs.MISTAKES),
    "sensor": ("The robot's description", table_sensor.MISTAKES),
    "output": ("Where results go", table_output.MISTAKES),
}
