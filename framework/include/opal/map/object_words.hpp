#pragma once

#include <opal/map/semantic_map.hpp>

#include <algorithm>
#include <string>

namespace opal {

/// A mapped thing for people: `Wall "Kitchen, north"`, or `Wall wall-0015` if it has no name. Types of Opal's own
/// vocabulary stand without their prefix.
/// @param type  prefixed IRI: "opal:Wall". @param id  in its map. @param name  as people call it; may be empty.
/// @param name_is_shared  another thing of this type has the same name: then the id follows.
inline std::string object_words(const std::string& type, const std::string& id, const std::string& name,
                                bool name_is_shared) {
  const std::string own = "opal:";
  const std::string kind = type.compare(0, own.size(), own) == 0 ? type.substr(own.size()) : type;
  if (name.empty()) return kind + " " + id;
  return kind + " \"" + name + "\"" + (name_is_shared ? " (" + id + ")" : "");
}

/// The same for an object of a map. @param map  that holds it. @param object  in that map.
inline std::string object_words(const SemanticMap& map, MapObjectNumber object) {
  const MapObject& it = map.object(object);
  if (it.notes.name.empty()) return object_words(it.type, it.id, "", false);  // nothing to compare with all others
  const bool shared = std::any_of(map.objects().begin(), map.objects().end(), [&](const MapObject& other) {
    return &other != &it && other.notes.name == it.notes.name && other.type == it.type;
  });
  return object_words(it.type, it.id, it.notes.name, shared);
}

}  // namespace opal
