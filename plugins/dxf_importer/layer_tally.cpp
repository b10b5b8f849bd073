#include "layer_tally.hpp"

#include <set>

namespace opal::dxf_importer {
namespace {

constexpr std::size_t kShownIds = 5;
constexpr int kShownLayers = 20;

}  // namespace

void LayerTally::count_used(const std::string& layer, const std::string& object_type, const std::string& entity_type) {
  ++used_[{layer, object_type}].by_type[entity_type];
}

void LayerTally::count_left_out(const std::string& layer, const std::string& why, const std::string& entity_type, const std::string& id) {
  Count& count = left_out_[{why, layer}];
  ++count.by_type[entity_type];
  if (count.ids.size() < kShownIds) count.ids.push_back(id);
}

std::string LayerTally::text_of(const Count& count) {
  std::string text;
  for (const auto& [type, number] : count.by_type) text += (text.empty() ? "" : ", ") + std::to_string(number) + " " + type;
  return text;
}

std::vector<std::string> LayerTally::sentences() const {
  std::vector<std::string> all;
  for (const auto& [key, count] : used_) all.push_back("layer " + key.first + " as " + key.second + ": " + text_of(count));
  for (const auto& [key, count] : left_out_) {
    std::string sentence = "left out, " + key.first + ": layer " + key.second + ": " + text_of(count) + " (";
    for (std::size_t k = 0; k < count.ids.size(); ++k) sentence += (k > 0 ? ", " : "") + count.ids[k];
    std::size_t total = 0;
    for (const auto& [type, number] : count.by_type) total += static_cast<std::size_t>(number);
    all.push_back(sentence + (total > count.ids.size() ? ", ...)" : ")"));
  }
  return all;
}

std::vector<std::string> LayerTally::layers() const {
  std::set<std::string> layers;
  for (const auto& [key, count] : used_) layers.insert(key.first);
  for (const auto& [key, count] : left_out_) layers.insert(key.second);
  return {layers.begin(), layers.end()};
}

std::string LayerTally::overview() const {
  std::map<std::string, Count> by_layer;
  const auto add = [&](const std::string& layer, const Count& count) {
    for (const auto& [type, number] : count.by_type) by_layer[layer].by_type[type] += number;
  };
  for (const auto& [key, count] : used_) add(key.first, count);
  for (const auto& [key, count] : left_out_) add(key.second, count);
  std::string text;
  int shown = 0;
  for (const auto& [layer, count] : by_layer) {
    if (++shown > kShownLayers) return text + " and " + std::to_string(by_layer.size() - kShownLayers) + " more";
    text += (text.empty() ? "" : ", ") + ("'" + layer + "' (" + text_of(count) + ")");
  }
  return text;
}

}  // namespace opal::dxf_importer
