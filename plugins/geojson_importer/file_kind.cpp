#include "file_kind.hpp"

#include <opal/common/letter_case.hpp>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>

namespace opal::geojson_importer {
namespace {

namespace fs = std::filesystem;

constexpr std::streamoff kEnd_bytes = 4096;

/// ".geojson" of "Plan.GEOJSON".
std::string ending_of(const std::string& path) { return lower_case_letters(fs::path(path).extension().string()); }

std::string read_at(std::ifstream& file, std::streamoff from) {
  std::string text(static_cast<std::size_t>(kEnd_bytes), '\0');
  file.clear();
  file.seekg(from);
  file.read(text.data(), kEnd_bytes);
  text.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
  return text;
}

/// The first and the last bytes of a file: members of an object stand in any order.
struct Ends {
  std::string first, last;

  bool any_has(const char* word) const { return has(word) || last.find(word) != std::string::npos; }
  bool has(const char* word) const { return first.find(word) != std::string::npos; }
};

Ends ends_of(const std::string& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return {};
  std::ifstream file(path, std::ios::binary);
  const auto size = static_cast<std::streamoff>(fs::file_size(path, error));
  return {read_at(file, 0), read_at(file, std::max<std::streamoff>(size - kEnd_bytes, 0))};
}

bool is_osm_xml(const std::string& ending, const Ends& ends) {
  return (ending == ".osm" || ending == ".xml") && ends.has("<osm");
}

/// An object with `elements` that have positions or nodes, and no features.
bool is_overpass(const std::string& ending, const Ends& ends) {
  return (ending == ".json" || ending == ".geojson") && ends.has("\"elements\"") &&
         (ends.any_has("\"osm3s\"") || ends.any_has("\"nodes\"") || ends.any_has("\"lat\"")) &&
         !ends.any_has("\"FeatureCollection\"") && !ends.has("\"features\"");
}

/// Lines or records, each a feature, as GDAL, tippecanoe and map servers write them.
bool is_lines_of_features(const std::string& ending, const Ends& ends) {
  constexpr std::array kEndings{".geojsonl", ".geojsons", ".geojsonseq", ".ndgeojson", ".ndjson", ".jsonl", ".json"};
  return std::find(kEndings.begin(), kEndings.end(), ending) != kEndings.end() && ends.has("\"Feature\"") &&
         ends.any_has("\"geometry\"");
}

}  // namespace

bool looks_like_plan(const std::string& path) {
  const std::string ending = ending_of(path);
  const Ends ends = ends_of(path);
  if (ends.first.empty()) return false;
  if (ending == ".geojson" || is_osm_xml(ending, ends) || is_overpass(ending, ends) ||
      is_lines_of_features(ending, ends))
    return true;
  return ending == ".json" &&
         (ends.any_has("\"FeatureCollection\"") || (ends.has("\"features\"") && ends.has("\"geometry\"")));
}

OsmForm osm_form_of(const std::string& path) {
  const std::string ending = ending_of(path);
  const Ends ends = ends_of(path);
  if (is_osm_xml(ending, ends)) return OsmForm::xml;
  return is_overpass(ending, ends) ? OsmForm::json : OsmForm::none;
}

}  // namespace opal::geojson_importer
