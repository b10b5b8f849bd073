#include "drawn_grid.hpp"

#include <opal/plugin/plugin_registry.hpp>

#include <png.h>

#include <stdexcept>

namespace opal::test {

std::shared_ptr<const MapImporter> grid_importer(const nlohmann::json& options) {
  PluginRegistry registry;
  registry.load(OPAL_PLUGIN_DIR "/grid_importer.so");
  return registry.make<MapImporter>("opal:GridImporter", options);
}

DrawnGrid& DrawnGrid::fill(std::uint8_t shade, int left, int bottom, int right, int top) {
  for (int row = bottom; row <= top; ++row)
    for (int column = left; column <= right; ++column) at(column, row) = shade;
  return *this;
}

DrawnGrid& DrawnGrid::room(int left, int bottom, int right, int top) {
  return fill(kOccupied, left, bottom, right, top).fill(kFree, left + 1, bottom + 1, right - 1, top - 1);
}

DrawnGrid DrawnGrid::shifted(int columns, int rows) const {
  DrawnGrid moved(columns_, rows_);
  for (int row = 0; row < rows_; ++row)
    for (int column = 0; column < columns_; ++column)
      if (row + rows < rows_ && column + columns < columns_) moved.at(column + columns, row + rows) = at(column, row);
  return moved;
}

DrawnGrid DrawnGrid::turned_left() const {
  DrawnGrid turned(rows_, columns_);
  for (int row = 0; row < rows_; ++row)
    for (int column = 0; column < columns_; ++column) turned.at(rows_ - 1 - row, column) = at(column, row);
  return turned;
}

std::string DrawnGrid::pgm() const {
  std::string bytes = "P5\n# drawn by a test\n" + std::to_string(columns_) + " " + std::to_string(rows_) + "\n255\n";
  for (int row = rows_ - 1; row >= 0; --row)
    for (int column = 0; column < columns_; ++column) bytes += static_cast<char>(at(column, row));
  return bytes;
}

std::string DrawnGrid::png() const {
  const std::string pixels = pgm().substr(pgm().size() - pixels_.size());
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.format = PNG_FORMAT_GRAY;
  image.width = static_cast<png_uint_32>(columns_);
  image.height = static_cast<png_uint_32>(rows_);
  std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(image), '\0');
  png_alloc_size_t size = bytes.size();
  if (!png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels.data(), 0, nullptr))
    throw std::runtime_error(image.message);
  bytes.resize(size);
  return bytes;
}

std::string yaml_for(const std::string& image, const std::string& origin, const std::string& more) {
  return "image: " + image + "\nresolution: 0.05\norigin: " + origin + "\n" + more;
}

MapImport import(const DrawnGrid& grid, const nlohmann::json& options) {
  const TemporaryFolder folder;
  folder.write("drawn.pgm", grid.pgm());
  return grid_importer(options)->import(folder.write("drawn.yaml", yaml_for("drawn.pgm")));
}

}  // namespace opal::test
