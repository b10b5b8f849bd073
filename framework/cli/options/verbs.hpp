#pragma once

#include <CLI/CLI.hpp>

namespace opal::cli {

/// Each verb adds its subcommand with its options to the program, and sets the exit code when it has run.

/// `opal plugins [FOLDER or FILE...]`: what plugins offer. Exit code 1 if one was refused or breaks its
/// contract.
void add_plugins_verb(CLI::App& app, int& exit_code);

/// `opal demo`: a first run on data that ship with the program.
void add_demo_verb(CLI::App& app, int& exit_code);

/// `opal info LOG`: what is in a recorded log, and what of it a deployment needs. Exit code 1 if it has no laser that
/// can be read.
void add_info_verb(CLI::App& app, int& exit_code);

/// `opal map import|check|push|pull|...`: bring a building in, see what it would run, share it. Exit code 1 if the map
/// has warnings that keep it from being used.
void add_map_verb(CLI::App& app, int& exit_code);

/// `opal localize CONFIG LOG`: the pose along a recorded log. Exit code 1 unless localized at the end.
void add_localize_verb(CLI::App& app, int& exit_code);

/// `opal track CONFIG LOG --pose X,Y,THETA`: the pose along a recorded log from a known start, and where the building
/// differs from its map. Exit code 1 if it is lost at the end.
void add_track_verb(CLI::App& app, int& exit_code);

/// `opal learn MAP LOG...`: where the building differs from its map, as drives say that nobody told the pose of. Exit
/// code 1 if nothing was learned.
void add_learn_verb(CLI::App& app, int& exit_code);

/// `opal explain OUT --at T`: why the localizer believed what it believed, in words.
void add_explain_verb(CLI::App& app, int& exit_code);

/// `opal view OUT...`: the run as one HTML file, or a moment of it as a picture.
void add_view_verb(CLI::App& app, int& exit_code);

/// `opal bench PREFIX -o OUT`: one recorded place from end to end. Reads ground truth only to kidnap robots and
/// to judge what became of them.
void add_bench_verb(CLI::App& app, int& exit_code);

/// `opal simulate MAP -o PREFIX`: a recording with ground truth of drives through a building that does not exist.
void add_simulate_verb(CLI::App& app, int& exit_code);

/// `opal drive CONFIG MAP`: a simulated robot that does not know where it is drives to a goal. Exit code 1 if a drive
/// does not get there.
void add_drive_verb(CLI::App& app, int& exit_code);

/// `opal serve CONFIG`: localizes a robot whose behaviours are another program on this machine.
void add_serve_verb(CLI::App& app, int& exit_code);

/// `opal ros2 CONFIG --map MAP`: localizes a running robot as a node of ROS 2. With --check the exit code is 1 if
/// something that is needed is missing.
void add_ros2_verb(CLI::App& app, int& exit_code);

/// `opal experiment thesis3 --map MAP -o OUT`: the thesis' challenges in simulation, in its table.
void add_experiment_verb(CLI::App& app, int& exit_code);

/// `opal ab EXPERIMENT`: several arms on the same logs, with a verdict. Exit code 1 if cells are missing when they are
/// collected.
void add_ab_verb(CLI::App& app, int& exit_code);

/// `opal calibrate CONFIG LOG`: the laser's mount and the scales of the odometry, from a drive.
void add_calibrate_verb(CLI::App& app, int& exit_code);

/// `opal calibration RUN...`: how far the probabilities of bench runs can be trusted.
void add_calibration_verb(CLI::App& app, int& exit_code);

}  // namespace opal::cli
