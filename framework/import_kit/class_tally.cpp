#include <opal/import_kit/class_tally.hpp>

#include "common/phrases.hpp"

#include <fmt/format.h>

#include <set>

namespace opal {
namespace {

constexpr std::size_t kShownIds = 5;
constexpr std::size_t kShownClasses = 20;

}  // namespace

void ClassTally::count_used(const std::string& source_class, const std::string& object_type,
                            const std::string& entity_type) {
  ++used_[{source_class, object_type}].by_type[entity_type];
}

void ClassTally::count_left_out(const std::string& source_class, const std::string& why, const std::string& entity_type,
                                const std::string& id) {
  Count& count = left_out_[{why, source_class}];
  ++count.by_type[entity_type];
  if (count.ids.size() < kShownIds) count.ids.push_back(id);
}

std::string ClassTally::text_of(const Count& count) {
  return listed_by(count.by_type, [](const auto& type) { return fmt::format("{} {}", type.second, type.first); });
}

std::vector<std::string> ClassTally::sentences() const {
  std::vector<std::string> all;
  for (const auto& [key, count] : used_)
    all.push_back(noun_ + " " + key.first + " as " + key.second + ": " + text_of(count));
  for (const auto& [key, count] : left_out_) {
    std::string sentence = "left out, " + key.first + ": " + noun_ + " " + key.second + ": " + text_of(count) + " (";
    for (std::size_t k = 0; k < count.ids.size(); ++k) sentence += (k > 0 ? ", " : "") + count.ids[k];
    std::size_t total = 0;
    for (const auto& [type, number] : count.by_type) total += static_cast<std::size_t>(number);
    all.push_back(sentence + (total > count.ids.size() ? ", ...)" : ")"));
  }
  return all;
}

std::vector<std::string> ClassTally::classes() const {
  std::set<std::string> classes;
  for (const auto& [key, count] : used_) classes.insert(key.first);
  for (const auto& [key, count] : left_out_) classes.insert(key.second);
  return {classes.begin(), classes.end()};
}

std::string ClassTally::overview() const {
  std::map<std::string, Count> by_class;
  const auto add = [&](const std::string& source_class, const Count& count) {
    for (const auto& [type, number] : count.by_type) by_class[source_class].by_type[type] += number;
  };
  for (const auto& [key, count] : used_) add(key.first, count);
  for (const auto& [key, count] : left_out_) add(key.second, count);
  std::vector<std::string> texts;
  for (const auto& [source_class, count] : by_class)
    texts.push_back(fmt::format("'{}' ({})", source_class, text_of(count)));
  return listed(texts, "", kShownClasses);
}

}  // namespace opal
