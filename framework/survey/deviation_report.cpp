#include "survey/deviation_report.hpp"

#include <fmt/format.h>
#include <Eigen/Dense>

#include <algorithm>

namespace opal {
namespace {

/// What the faces and columns of one object say about where it is, gathered as normal equations of its displacement.
class ObjectEvidence {
 public:
  explicit ObjectEvidence(const DeviationOptions& options) : options_(options) {}

  void add(MapFeatureNumber number, const MapFeature& feature, const FeatureBelief& belief) {
    const Geometry& geometry = feature.geometry;
    seen_ += belief.seen;
    through_ += belief.seen_through;
    if (const auto* face = std::get_if<Segment>(&geometry))
      add_face(number, feature.id, *face, belief);
    else if (std::holds_alternative<Circle>(geometry))
      add_column(number, belief);
  }

  /// @return false if too little was seen to say anything.
  bool report(Deviation& deviation) const {
    const double all = seen_ + through_;
    deviation.seen_through_share = all > 0 ? through_ / all : 0;
    const bool absent = all >= options_.least_observations && deviation.seen_through_share > options_.absent_share;
    deviation.feature = main_.exists() ? main_ : any_;
    deviation.observations = observations_;
    deviation.looks = all;
    deviation.faces = faces_;
    if (!main_.exists() && !absent) return false;
    if (main_.exists()) locate(deviation);
    const double least = std::max(options_.least_offset_m, options_.sigmas * deviation.sigma_m);
    const bool moved = main_.exists() && std::abs(deviation.offset_m) > least;
    deviation.verdict = absent  ? DeviationVerdict::probably_absent
                        : moved ? DeviationVerdict::moved
                                : DeviationVerdict::as_mapped;
    return true;
  }

 private:
  bool tells(const FeatureBelief& belief) const { return belief.observations >= options_.least_observations; }

  void add_face(MapFeatureNumber number, const std::string& id, const Segment& face, const FeatureBelief& belief) {
    if (!any_.exists()) any_ = number;
    if (!tells(belief) || belief.covered_m < options_.least_covered_m) return;
    const double weight = 1 / (belief.sigma_m * belief.sigma_m);
    const Point normal = face.normal();
    faces_.push_back({id, normal.dot(belief.moved), belief.sigma_m});
    information_ += weight * normal * normal.transpose();
    pull_ += weight * normal * normal.dot(belief.moved);
    observations_ = std::max(observations_, belief.observations);
    if (main_.exists() && belief.covered_m <= covered_m_) return;
    main_ = number;
    covered_m_ = belief.covered_m;
    normal_ = normal;
  }

  void add_column(MapFeatureNumber number, const FeatureBelief& belief) {
    if (!any_.exists()) any_ = number;
    if (!tells(belief)) return;
    main_ = number;
    observations_ = belief.observations;
    const double weight = 1 / (belief.sigma_m * belief.sigma_m);
    information_ += weight * Eigen::Matrix2d::Identity();
    pull_ += weight * belief.moved;
    normal_ = belief.moved.norm() > 0 ? Point(belief.moved.normalized()) : Point(Point::UnitX());
  }

  /// A face says nothing about the way along it, so a weak prior keeps the object from sliding there.
  void locate(Deviation& deviation) const {
    constexpr double kPriorSigma_m = 1;
    const Eigen::Matrix2d information = information_ + Eigen::Matrix2d::Identity() / (kPriorSigma_m * kPriorSigma_m);
    const Eigen::Matrix2d covariance = information.inverse();
    deviation.moved = covariance * pull_;
    deviation.offset_m = normal_.dot(deviation.moved);
    deviation.sigma_m = std::sqrt(normal_.dot(covariance * normal_));
  }

  const DeviationOptions& options_;
  Eigen::Matrix2d information_ = Eigen::Matrix2d::Zero();
  Point pull_ = Point::Zero(), normal_ = Point::UnitX();
  double seen_ = 0, through_ = 0, covered_m_ = 0;
  MapFeatureNumber main_, any_;
  int observations_ = 0;
  std::vector<FaceOffset> faces_;
};

bool farther(const Deviation& a, const Deviation& b) {
  const bool a_absent = a.verdict == DeviationVerdict::probably_absent;
  const bool b_absent = b.verdict == DeviationVerdict::probably_absent;
  if (a_absent != b_absent) return b_absent;
  return std::abs(a.offset_m) > std::abs(b.offset_m);
}

double rounded(double value) { return std::round(1000 * value) / 1000; }

}  // namespace

const char* name_of(DeviationVerdict verdict) {
  switch (verdict) {
    case DeviationVerdict::as_mapped: return "as mapped";
    case DeviationVerdict::moved: return "moved";
    case DeviationVerdict::probably_absent: return "probably absent";
  }
  return "";
}

std::vector<Deviation> deviations_of(const SemanticMap& map, const MapBelief& belief, const DeviationOptions& options) {
  std::vector<Deviation> found;
  for (const MapObject& object : map.objects()) {
    ObjectEvidence evidence(options);
    for (MapFeatureNumber number : object.features) evidence.add(number, map.feature(number), belief[number]);
    Deviation deviation;
    deviation.object = object.id;
    deviation.type = object.type;
    if (evidence.report(deviation)) found.push_back(std::move(deviation));
  }
  std::stable_sort(found.begin(), found.end(), farther);
  return found;
}

nlohmann::ordered_json to_json(const SemanticMap& map, const std::vector<Deviation>& deviations) {
  auto objects = nlohmann::ordered_json::array();
  for (const Deviation& d : deviations)
    objects.push_back({{"object", d.object},
                       {"type", d.type},
                       {"verdict", name_of(d.verdict)},
                       {"feature", map.feature(d.feature).id},
                       {"offset_m", rounded(d.offset_m)},
                       {"sigma_m", rounded(d.sigma_m)},
                       {"moved_x_m", rounded(d.moved.x())},
                       {"moved_y_m", rounded(d.moved.y())},
                       {"observations", d.observations},
                       {"seen_through_share", rounded(d.seen_through_share)}});
  return {{"map", map.name()}, {"objects", std::move(objects)}};
}

std::string to_table(const std::vector<Deviation>& deviations) {
  std::string table = "offset m  +-  m  keyframes  seen through  verdict          object\n";
  for (const Deviation& d : deviations) {
    table += fmt::format("{:8.2f}  {:5.2f}  {:9}  {:10.0f} %  {:<15}  {} {}\n", d.offset_m, d.sigma_m, d.observations,
                         100 * d.seen_through_share, name_of(d.verdict), d.type, d.object);
  }
  return table;
}

}  // namespace opal
