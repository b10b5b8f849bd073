#pragma once

#include "common/random.hpp"

#include <opal/sensing/log_source.hpp>

#include <array>
#include <string>
#include <vector>

namespace opal::simulation {

/// A record, and when it arrives by a clock that never jumps.
struct Arrival {
  double at_s = 0;
  LogRecord record;
};

/// What goes wrong with the streams of a robot's sensors.
enum class Fault {
  none,
  dropped,          ///< a third of all records is lost
  doubled,          ///< a third of all records comes twice
  reordered,        ///< a third of all records overtakes others, by up to 0.15 s
  late,             ///< scans arrive 0.5 s late
  clock_back,       ///< stamps jump back by 10 s, and stay there
  laser_gone,       ///< one laser says nothing
  odometry_frozen,  ///< odometry stands still while the robot drives
  wheels_slip       ///< odometry counts nearly twice the way
};
/// All but `none`.
inline constexpr std::array kFaults{Fault::dropped,    Fault::doubled,    Fault::reordered,       Fault::late,
                                    Fault::clock_back, Fault::laser_gone, Fault::odometry_frozen, Fault::wheels_slip};
/// "wheels slip": the fault as tables and options write it.
const char* name_of(Fault fault);

/// When a fault lasts.
struct FaultWindow {
  double from_s = 0, to_s = 0;
};

/// Records as they arrive on a robot where all is well: odometry 35 ms after its stamp, a scan 5 ms after its last beam
/// (measured on recordings of robots).
/// @param records  by the time at which they are known. @param sweep_s  of a scan.
std::vector<Arrival> arrivals_of(const std::vector<LogRecord>& records, double sweep_s);

/// The same with a fault, by arrival.
/// @param laser  the frame of the laser that is gone.
std::vector<Arrival> with_fault(std::vector<Arrival> arrivals, Fault fault, const FaultWindow& window,
                                const std::string& laser, Random random);

/// By the clock that never jumps, a stamp that was told at `now_s` in a drive with a fault.
double true_stamp_s(Fault fault, const FaultWindow& window, double said_s, double now_s);

}  // namespace opal::simulation
