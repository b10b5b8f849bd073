#include "session/moved_deployment.hpp"

#include "common/json/config_object.hpp"
#include "deployment/class_files.hpp"
#include "deployment/store_source.hpp"

#include <filesystem>

namespace opal::session {
namespace {

namespace fs = std::filesystem;

fs::path folder_of(const std::string& file) { return fs::absolute(file).lexically_normal().parent_path(); }

class Move {
 public:
  Move(const std::string& from, const std::string& to) : from_(fs::absolute(from).string()), to_(folder_of(to)) {}

  std::string operator()(const std::string& path) const {
    if (path.empty() || fs::path(path).is_absolute()) return path;
    return fs::path(beside(from_, path)).lexically_proximate(to_).string();
  }

 private:
  std::string from_;
  fs::path to_;
};

void move_map(nlohmann::ordered_json& path, const Move& moved) {
  if (path.is_string() && !read_store_source(path)) path = moved(path);
}

void move_classes(nlohmann::ordered_json& document, const Move& moved) {
  nlohmann::json named;
  for (const char* list : {"detectors", "patterns", "scorers", "trusted_plugins"})
    if (document.contains(list)) named[list] = document[list];
  const nlohmann::json found =
      with_classes_named(named, [&](const ClassSource& source) { return moved(source.file) + ":" + source.name; });
  for (const auto& [list, parts] : found.items())
    if (parts != named[list]) document[list] = parts;
}

}  // namespace

nlohmann::ordered_json moved_deployment(nlohmann::ordered_json document, const std::string& from,
                                        const std::string& to) {
  if (folder_of(from) == folder_of(to)) return document;
  const Move moved(from, to);
  if (document.contains("map")) move_map(document["map"], moved);
  if (document.contains("overlays"))
    for (nlohmann::ordered_json& overlay : document["overlays"]) move_map(overlay, moved);
  move_classes(document, moved);
  return document;
}

}  // namespace opal::session
