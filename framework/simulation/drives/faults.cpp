#include "simulation/drives/faults.hpp"

#include <algorithm>
#include <optional>

namespace opal::simulation {
namespace {

constexpr double kOdometryAfter_s = 0.035, kScanAfter_s = 0.005;
constexpr double kShare = 0.33, kOvertaken_s = 0.15, kLate_s = 0.5, kBack_s = 10, kSlip = 1.8;

bool is_scan(const Arrival& arrival) { return std::holds_alternative<RawScan>(arrival.record); }

double* stamp_in(LogRecord& record) {
  if (auto* scan = std::get_if<RawScan>(&record)) return &scan->stamp_s;
  if (auto* odometry = std::get_if<OdometryRecord>(&record)) return &odometry->stamp_s;
  return nullptr;
}

Pose2* odometry_in(LogRecord& record) {
  if (auto* odometry = std::get_if<OdometryRecord>(&record)) return &odometry->T_odom_base;
  auto* scan = std::get_if<RawScan>(&record);
  return scan && scan->T_odom_base ? &*scan->T_odom_base : nullptr;
}

/// Odometry whose steps are other than the robot's for a while. It goes on from where it then is.
class WrongOdometry {
 public:
  explicit WrongOdometry(double steps) : steps_(steps) {}

  Pose2 next(const Pose2& T_odom_base, bool is_wrong) {
    const Pose2 step = T_before_ ? T_before_->inverse() * T_odom_base : Pose2();
    if (!T_before_) T_said_ = T_odom_base;
    const Pose2 said(steps_ * step.x(), steps_ * step.y(), steps_ * step.heading_rad());
    T_said_ = T_before_ ? T_said_ * (is_wrong ? said : step) : T_said_;
    T_before_ = T_odom_base;
    return T_said_;
  }

 private:
  double steps_;
  std::optional<Pose2> T_before_;
  Pose2 T_said_;
};

/// Who is asked in the order of stamps sees each step once.
void falsify_odometry(std::vector<Arrival>& arrivals, const FaultWindow& window, double steps) {
  std::vector<Arrival*> by_stamp;
  for (Arrival& arrival : arrivals)
    if (odometry_in(arrival.record)) by_stamp.push_back(&arrival);
  std::ranges::stable_sort(by_stamp,
                           [](Arrival* a, Arrival* b) { return *stamp_in(a->record) < *stamp_in(b->record); });
  WrongOdometry wrong(steps);
  for (Arrival* arrival : by_stamp) {
    const double stamp_s = *stamp_in(arrival->record);
    Pose2& pose = *odometry_in(arrival->record);
    pose = wrong.next(pose, stamp_s >= window.from_s && stamp_s < window.to_s);
  }
}

/// Of what arrives while the fault lasts.
class Disturbing {
 public:
  Disturbing(Fault fault, std::string laser, Random& random)
      : fault_(fault), laser_(std::move(laser)), random_(random) {}

  void add(Arrival arrival, std::vector<Arrival>& out) {
    if (fault_ == Fault::dropped && random_.chance(kShare)) return;
    if (fault_ == Fault::laser_gone && is_scan(arrival) && std::get<RawScan>(arrival.record).frame == laser_) return;
    if (fault_ == Fault::doubled && random_.chance(kShare)) out.push_back(arrival);
    if (fault_ == Fault::reordered && random_.chance(kShare)) arrival.at_s += random_.uniform(0, kOvertaken_s);
    if (fault_ == Fault::late && is_scan(arrival)) arrival.at_s += kLate_s;
    out.push_back(std::move(arrival));
  }

 private:
  Fault fault_;
  std::string laser_;
  Random& random_;
};

}  // namespace

const char* name_of(Fault fault) {
  switch (fault) {
    case Fault::none: return "none";
    case Fault::dropped: return "dropped";
    case Fault::doubled: return "doubled";
    case Fault::reordered: return "reordered";
    case Fault::late: return "late";
    case Fault::clock_back: return "clock back";
    case Fault::laser_gone: return "laser gone";
    case Fault::odometry_frozen: return "odometry frozen";
    case Fault::wheels_slip: return "wheels slip";
  }
  return "";
}

std::vector<Arrival> arrivals_of(const std::vector<LogRecord>& records, double sweep_s) {
  std::vector<Arrival> arrivals;
  for (LogRecord record : records) {
    const bool is_scan = std::holds_alternative<RawScan>(record);
    const double* stamp_s = stamp_in(record);
    const double known_s = stamp_s ? *stamp_s + (is_scan ? sweep_s + kScanAfter_s : kOdometryAfter_s) : 0;
    arrivals.push_back({known_s, std::move(record)});
  }
  std::ranges::stable_sort(arrivals, {}, &Arrival::at_s);
  return arrivals;
}

std::vector<Arrival> with_fault(std::vector<Arrival> arrivals, Fault fault, const FaultWindow& window,
                                const std::string& laser, Random random) {
  if (fault == Fault::odometry_frozen) falsify_odometry(arrivals, window, 0);
  if (fault == Fault::wheels_slip) falsify_odometry(arrivals, window, kSlip);
  Disturbing disturbing(fault, laser, random);
  std::vector<Arrival> faulty;
  for (Arrival& arrival : arrivals) {
    if (fault == Fault::clock_back && arrival.at_s >= window.from_s)
      if (double* stamp_s = stamp_in(arrival.record)) *stamp_s -= kBack_s;
    const bool is_now = arrival.at_s >= window.from_s && arrival.at_s < window.to_s;
    if (is_now)
      disturbing.add(std::move(arrival), faulty);
    else
      faulty.push_back(std::move(arrival));
  }
  std::ranges::stable_sort(faulty, {}, &Arrival::at_s);
  return faulty;
}

double true_stamp_s(Fault fault, const FaultWindow& window, double said_s, double now_s) {
  const bool is_back = fault == Fault::clock_back && now_s >= window.from_s && said_s < now_s - kBack_s / 2;
  return said_s + (is_back ? kBack_s : 0);
}

}  // namespace opal::simulation
