// A plugin without a fault, to compare with: its detector finds as many points as its option says. When it is opened,
// its constructor leaves a trace.
#include <opal/plugin/plugin.hpp>

#include <cstdlib>

namespace {

const int trace = setenv("OPAL_TEST_GOOD_WAS_OPENED", "yes", 1);

class CountingDetector final : public opal::FeatureDetector {
 public:
  explicit CountingDetector(int count) : count_(count) {}
  std::vector<opal::Feature> detect(const opal::Scan&) const override {
    opal::Feature feature;
    feature.type = "bad:Thing";
    feature.covariance.topLeftCorner<2, 2>().setIdentity();
    return std::vector<opal::Feature>(static_cast<std::size_t>(count_), feature);
  }

 private:
  int count_;
};

int count_from(const nlohmann::json& options) { return options.at("count"); }

void register_types(opal::Registrar& registrar) {
  registrar.add<CountingDetector>({.name = "bad:good", .produces = {"bad:Thing"}}, count_from);
}

}  // namespace

OPAL_PLUGIN("good", "1.2.3", register_types)
