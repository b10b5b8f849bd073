#include "ros2/network/ros_names.hpp"

#include <algorithm>
#include <cctype>

namespace opal::ros2 {
namespace {

constexpr const char* kTopicPrefix = "rt";
constexpr const char* kTypeInfix = "::dds_::";

std::string with_slash(const std::string& name) { return name.starts_with('/') ? name : "/" + name; }

bool is_word(const std::string& word) {
  const auto fits = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
  return !word.empty() && std::isdigit(static_cast<unsigned char>(word[0])) == 0 && std::ranges::all_of(word, fits);
}

std::string with_slashes_for_colons(std::string text) {
  for (std::size_t at = text.find("::"); at != std::string::npos; at = text.find("::")) text.replace(at, 2, "/");
  return text;
}

}  // namespace

std::string topic_in(const std::string& name_space, const std::string& name) {
  if (name.starts_with('/') || name_space.empty() || name_space == "/") return with_slash(name);
  const std::string outer = name_space.ends_with('/') ? name_space.substr(0, name_space.size() - 1) : name_space;
  return with_slash(outer) + "/" + name;
}

std::string dds_topic(const std::string& topic) { return kTopicPrefix + with_slash(topic); }

std::string ros_topic(const std::string& dds_topic) {
  return dds_topic.starts_with(std::string(kTopicPrefix) + "/") ? dds_topic.substr(2) : "";
}

std::string ros_type(const std::string& dds_type) {
  const std::size_t infix = dds_type.find(kTypeInfix);
  if (infix == std::string::npos || !dds_type.ends_with('_')) return dds_type;
  const std::string name = dds_type.substr(infix + std::string(kTypeInfix).size());
  return with_slashes_for_colons(dds_type.substr(0, infix)) + "/" + name.substr(0, name.size() - 1);
}

bool is_topic_name(const std::string& name) {
  std::size_t begin = name.starts_with('/') ? 1 : 0;
  while (true) {
    const std::size_t end = std::min(name.find('/', begin), name.size());
    if (!is_word(name.substr(begin, end - begin))) return false;
    if (end == name.size()) return true;
    begin = end + 1;
  }
}

}  // namespace opal::ros2
