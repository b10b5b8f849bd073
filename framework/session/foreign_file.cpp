#include "session/foreign_file.hpp"

#include <opal/common/letter_case.hpp>

#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <string_view>

namespace opal {
namespace {

struct Kind {
  std::string_view begin;   ///< of the file, after spaces; empty: any
  std::string_view ending;  ///< of its name, in small letters; empty: any
  std::string_view what;
};

constexpr std::array kPlaceholders{
    Kind{"version https://git-lfs", "", "is a pointer of Git LFS, expected the file itself: git lfs pull fetches it"},
    Kind{"<!doctype html", "", "is a web page, expected the file that it shows: download that one itself (\"Raw\")"},
    Kind{"<html", "", "is a web page, expected the file that it shows: download that one itself (\"Raw\")"}};
// More special ones first.
constexpr std::array kKinds{
    Kind{"PK\3\4", ".ifczip", "is a ZIP archive, expected the building model in it: unpack it first"},
    Kind{"PK\3\4", "", "is a ZIP archive, expected what is in it: unpack it first (of IMDF, name the folder)"},
    Kind{"\x1F\x8B", ".osm.gz", "is compressed by gzip, expected what is in it: gunzip it first"},
    Kind{"7z\xBC\xAF", "", "is a 7z archive, expected what is in it: unpack it first"},
    Kind{"Rar!", "", "is a RAR archive, expected what is in it: unpack it first"},
    Kind{"%pdf", "", "is a PDF, expected a drawing (DXF) or a picture with a map_server yaml file"},
    Kind{"", ".svg",
         "is an SVG, expected a drawing (DXF) or a picture (PNG) with a map_server yaml file: Inkscape saves both"},
    Kind{"", ".ifcxml", "is a building model in XML, expected the same as text (STEP, .ifc)"},
    Kind{"", ".pbstream",
         "is a state of Cartographer, expected its map: cartographer_pbstream_to_ros_map writes yaml and pgm"},
    Kind{"", ".posegraph", "is a graph of slam_toolbox, expected its map: map_saver_cli writes yaml and pgm"},
    Kind{"", ".pbf", "is an extract of OpenStreetMap in PBF, expected XML: osmium cat FILE -o FILE.osm"},
    Kind{"", ".shp", "is a shapefile, expected GeoJSON: ogr2ogr FILE.geojson FILE.shp"},
    Kind{"", ".gpkg", "is a GeoPackage, expected GeoJSON: ogr2ogr FILE.geojson FILE.gpkg"},
    Kind{"", ".kml", "is KML, expected GeoJSON: ogr2ogr FILE.geojson FILE.kml"},
    Kind{"", ".rvt", "is a model of Revit, expected its export as IFC"},
    Kind{"\x89PNG", "", "is a picture, expected the map_server yaml file that says how large a pixel is"},
    Kind{"\xFF\xD8", "", "is a picture, expected the map_server yaml file that says how large a pixel is"},
    Kind{"", ".pgm", "is a picture, expected the map_server yaml file that says how large a pixel is"},
    Kind{"", ".bmp", "is a picture, expected the map_server yaml file that says how large a pixel is"}};

std::string first_bytes(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string bytes(64, '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(file.gcount()));
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.erase(0, 3);
  bytes.erase(0, bytes.find_first_not_of(" \t\r\n"));
  return bytes;
}

bool begins_with(std::string_view bytes, std::string_view begin) {
  const auto small = [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); };
  if (bytes.size() < begin.size()) return false;
  for (std::size_t k = 0; k < begin.size(); ++k)
    if (small(bytes[k]) != small(begin[k])) return false;
  return true;
}

template <std::size_t N>
std::string what_of(const std::string& path, const std::array<Kind, N>& kinds) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return "";
  const std::string bytes = first_bytes(path), name = lower_case_letters(path);
  for (const Kind& kind : kinds)
    if (begins_with(bytes, kind.begin) && name.ends_with(kind.ending)) return ": " + std::string(kind.what);
  return "";
}

}  // namespace

std::string what_placeholder(const std::string& path) { return what_of(path, kPlaceholders); }

std::string what_foreign_file(const std::string& path) { return what_of(path, kKinds); }

}  // namespace opal
