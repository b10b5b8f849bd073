#include "session/foreign_file.hpp"

#include <opal/common/file_start.hpp>
#include <opal/common/letter_case.hpp>

#include <array>
#include <cctype>
#include <filesystem>
#include <string_view>

namespace opal {
namespace {

struct Kind {
  std::string_view begin;   ///< of the file, after spaces; empty: any
  std::string_view ending;  ///< of its name, in small letters; empty: any
  std::string_view what;
  bool is_placeholder = false;
};

constexpr std::string_view kWebPage =
    "is a web page, expected the file that it shows: download that one itself (\"Raw\")";
constexpr std::string_view kPicture = "is a picture, expected the map_server yaml file that says how large a pixel is";
// More special ones first.
constexpr std::array kKinds{
    Kind{"version https://git-lfs", "", "is a pointer of Git LFS, expected the file itself: git lfs pull fetches it",
         true},
    Kind{"<!doctype html", "", kWebPage, true},
    Kind{"<html", "", kWebPage, true},
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
    Kind{"\x89PNG", "", kPicture},
    Kind{"\xFF\xD8", "", kPicture},
    Kind{"", ".pgm", kPicture},
    Kind{"", ".bmp", kPicture}};

bool begins_with(std::string_view bytes, std::string_view begin) {
  const auto small = [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); };
  if (bytes.size() < begin.size()) return false;
  for (std::size_t k = 0; k < begin.size(); ++k)
    if (small(bytes[k]) != small(begin[k])) return false;
  return true;
}

}  // namespace

ForeignFile what_foreign_file(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return {};
  std::string start = first_bytes(path, 64);
  erase_byte_order_mark(start);
  start.erase(0, start.find_first_not_of(" \t\r\n"));
  const std::string name = lower_case_letters(path);
  for (const Kind& kind : kKinds)
    if (begins_with(start, kind.begin) && name.ends_with(kind.ending))
      return {": " + std::string(kind.what), kind.is_placeholder};
  return {};
}

}  // namespace opal
