#include "filter.hpp"

#include <opal/common/error.hpp>

#include <mrpt/bayes/CParticleFilter.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/random.h>

#include <array>
#include <cmath>
#include <map>
#include <numbers>

/// MRPT's filter with another sensor model.
class ParticleFilter::Mrpt : public mrpt::slam::CMonteCarloLocalization2D {
 public:
  explicit Mrpt(const LikelihoodField& field) : field_(field) {}

  double PF_SLAM_computeObservationLikelihoodForParticle(const mrpt::bayes::CParticleFilter::TParticleFilterOptions&,
                                                         const size_t, const mrpt::obs::CSensoryFrame&,
                                                         const mrpt::poses::CPose3D& x) const override {
    return field_.log_weight(x.x(), x.y(), x.yaw());
  }

 private:
  const LikelihoodField& field_;
};

namespace {

std::vector<opal::Point> free_cells(const mrpt::maps::COccupancyGridMap2D& grid, const std::optional<Region>& region) {
  std::vector<opal::Point> cells;
  for (int row = 0; row < static_cast<int>(grid.getSizeY()); ++row)
    for (int column = 0; column < static_cast<int>(grid.getSizeX()); ++column) {
      if (grid.getCell(column, row) < 0.7f) continue;
      const opal::Point center(grid.idx2x(column), grid.idx2y(row));
      if (!region || (center - region->center).norm() < region->radius_m) cells.push_back(center);
    }
  return cells;
}

using Bin = std::array<int, 3>;

struct Cluster {
  double weight = 0, x = 0, y = 0, cosine = 0, sine = 0;
  void add(const Cluster& other) {
    weight += other.weight, x += other.x, y += other.y, cosine += other.cosine, sine += other.sine;
  }
};

/// Takes a bin and all that hang together with it out of the bins.
Cluster taken_with_neighbours(std::map<Bin, Cluster>& bins, const Bin& first, int headings) {
  Cluster cluster;
  std::vector<Bin> open{first};
  while (!open.empty()) {
    const Bin bin = open.back();
    open.pop_back();
    const auto found = bins.find(bin);
    if (found == bins.end()) continue;
    cluster.add(found->second);
    bins.erase(found);
    for (int k = 0; k < 27; ++k)
      open.push_back({bin[0] + k % 3 - 1, bin[1] + k / 3 % 3 - 1, (bin[2] + k / 9 - 1 + headings) % headings});
  }
  return cluster;
}

}  // namespace

ParticleFilter::ParticleFilter(const mrpt::maps::COccupancyGridMap2D::Ptr& grid, const LikelihoodField& field,
                               const FilterOptions& options, const std::optional<Region>& region, std::uint32_t seed)
    : options_(options), filter_(std::make_unique<Mrpt>(field)) {
  const std::vector<opal::Point> cells = free_cells(*grid, region);
  if (cells.empty()) throw opal::MapError("no free cell to spread particles over");
  auto& random = mrpt::random::getRandomGenerator();
  random.randomize(seed);
  filter_->clearParticles();
  filter_->m_particles.resize(static_cast<std::size_t>(options.most_particles));
  for (auto& particle : filter_->m_particles) {
    const opal::Point& cell = cells[std::min(
        cells.size() - 1, static_cast<std::size_t>(random.drawUniform(0.0, 1.0) * static_cast<double>(cells.size())))];
    const double half_m = grid->getResolution() / 2;
    particle.d = mrpt::math::TPose2D(cell.x() + random.drawUniform(-half_m, half_m),
                                     cell.y() + random.drawUniform(-half_m, half_m), random.drawUniform(-M_PI, M_PI));
    particle.log_w = 0;
  }
  filter_->options.metricMap = grid;  // MRPT asks for one, though the likelihood field stands in for it
  mrpt::slam::TKLDParams& kld = filter_->options.KLD_params;
  kld.KLD_binSize_XY = options.bin_m;
  kld.KLD_binSize_PHI = options.bin_rad;
  kld.KLD_delta = std::erfc(options.kld_z / std::numbers::sqrt2) / 2;
  kld.KLD_epsilon = options.kld_error;
  kld.KLD_minSampleSize = static_cast<unsigned>(options.least_particles);
  kld.KLD_maxSampleSize = static_cast<unsigned>(options.most_particles);
}

ParticleFilter::~ParticleFilter() = default;

void ParticleFilter::update(const opal::Pose2& step) {
  mrpt::obs::CActionRobotMovement2D movement;
  movement.poseChange = mrpt::poses::CPosePDFGaussian::Create(omni_motion(step, options_.motion));
  mrpt::obs::CActionCollection actions;
  actions.insert(movement);
  const mrpt::obs::CSensoryFrame reading;  // the likelihood field has it
  mrpt::bayes::CParticleFilter mcl;
  mcl.m_options.PF_algorithm = mrpt::bayes::CParticleFilter::pfStandardProposal;
  // MRPT draws anew before the update, and whenever it adapts the number; between, weights gather.
  mcl.m_options.adaptiveSampleSize = updates_ > 0 && updates_ % options_.resample_interval == 0;
  mcl.m_options.BETA = 0;
  mcl.executeOn(*filter_, &actions, &reading);
  ++updates_;
}

std::size_t ParticleFilter::particles() const { return filter_->particlesCount(); }

bool ParticleFilter::localized() const {
  const auto [covariance, mean] = filter_->getCovarianceAndMean();
  return covariance(0, 0) < options_.localized_m2 && covariance(1, 1) < options_.localized_m2;
}

opal::Pose2 ParticleFilter::best() const {
  const int headings = static_cast<int>(std::lround(2 * M_PI / options_.bin_rad));
  double most = -1e300;
  for (const auto& particle : filter_->m_particles) most = std::max(most, particle.log_w);
  std::map<Bin, Cluster> bins;
  for (const auto& particle : filter_->m_particles) {
    const double w = std::exp(particle.log_w - most), heading = particle.d.phi;
    const int turn = static_cast<int>(std::floor((opal::wrap_angle(heading) + M_PI) / options_.bin_rad));
    bins[{static_cast<int>(std::floor(particle.d.x / options_.bin_m)),
          static_cast<int>(std::floor(particle.d.y / options_.bin_m)), (turn % headings + headings) % headings}]
        .add({w, w * particle.d.x, w * particle.d.y, w * std::cos(heading), w * std::sin(heading)});
  }
  Cluster best;
  while (!bins.empty()) {
    const Cluster cluster = taken_with_neighbours(bins, bins.begin()->first, headings);
    if (cluster.weight > best.weight) best = cluster;
  }
  return {best.x / best.weight, best.y / best.weight, std::atan2(best.sine, best.cosine)};
}
