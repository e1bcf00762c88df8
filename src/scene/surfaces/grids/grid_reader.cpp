// Formats are recognised in this order: files with a magic number (PNG, PGM, TIFF and others for GDAL), models, which
// are not grids, and then text.

#include <cmath>

#include "files/named_input.hpp"
#include "files/utf16.hpp"
#include "scene/readers/format_readers.hpp"
#include "scene/readers/text_lines.hpp"
#include "scene/surfaces/grids/data_file.hpp"
#include "scene/surfaces/grids/grid_formats.hpp"
#include "scene/surfaces/height_filters.hpp"
#include "scene/surfaces/held_heights.hpp"
#include "scene/tables/cell_value.hpp"
#include "scene/tables/unpack.hpp"

namespace ligne {
namespace {

/// The kind of file that error messages name as wanted.
constexpr char kWanted[] = "a grid of heights";

/// Largest step of positions that count as degrees of a grid of the earth, and largest longitude and latitude.
constexpr double kWidestStepOfDegrees = 0.25, kMostLongitude = 360, kMostLatitude = 90;

std::unique_ptr<HeightSource> with_unit(std::unique_ptr<HeightSource> heights, GroundUnit unit) {
  heights->set_unit(unit);
  return heights;
}

std::unique_ptr<HeightSource> read_raster(std::span<const std::byte> bytes, const std::string& name, Warnings& warnings,
                                          const std::filesystem::path& file, InputFiles& opened, const GridChoice& choice) {
  const bool is_tiff = as_characters(bytes).starts_with("II") || as_characters(bytes).starts_with("MM");
  if (!is_tiff || !reads_tiff()) return read_gdal_grid(file, name, warnings, choice, opened);
  try {
    return read_tiff_grid(bytes, name, warnings, choice, file, &opened);
  } catch (const UnreadTiff&) {
    if (!reads_by_gdal() || file.empty()) throw;
    return read_gdal_grid(file, name, warnings, choice, opened);
  }
}

/// Unpacks an archive with a grid. A model that is a ZIP archive is refused.
std::optional<UnpackedFile> unpacked_grid(std::span<const std::byte> bytes, const std::string& name) {
  const std::string_view chars(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (chars.starts_with("PK\x03\x04")) refuse_models(bytes, name, kWanted);
  return unpacked(bytes, name);
}

/// Reads pictures and grids that have a magic number; null for other bytes.
std::unique_ptr<HeightSource> read_picture(std::span<const std::byte> bytes, const std::string& name, Warnings& warnings,
                                           const std::filesystem::path& file, InputFiles* opened, const GridChoice& choice) {
  const std::string_view chars(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (choice.band.value_or(1) != 1 && !is_for_gdal(chars)) {
    throw InputError(name, "has one band; --band works for GeoTIFF and the formats of GDAL");
  }
  if (chars.starts_with("\x89PNG")) return with_unit(read_png_grid(bytes, name, warnings, choice), GroundUnit::same);
  if (const char kind = netpbm_kind(chars)) {
    if (kind == '2' || kind == '5') return with_unit(read_pgm_grid(bytes, name, warnings, choice), GroundUnit::same);
    throw InputError(name, std::string("is a Netpbm picture P") + kind + "; heights need a grey one, P2 or P5");
  }
  if (is_hgt_name(name)) return read_hgt_grid(bytes, name, warnings);
  if (is_surfer_grid(chars)) return read_surfer_grid(bytes, name, warnings);
  InputFiles unasked;
  if (is_for_gdal(chars)) return read_raster(bytes, name, warnings, file, opened ? *opened : unasked, choice);
  return nullptr;
}

/// Wraps the single surface that most formats have.
std::vector<GridSurface> alone(std::unique_ptr<HeightSource> heights) {
  std::vector<GridSurface> surfaces;
  surfaces.push_back({std::move(heights), {}});
  return surfaces;
}

std::unique_ptr<HeightSource> heights_alone(std::vector<GridSurface> surfaces, const std::string& name) {
  if (surfaces.size() > 1) throw InputError(name, "holds " + std::to_string(surfaces.size()) + " surfaces, not one");
  if (surfaces.front().mesh) throw InputError(name, "holds a mesh whose x and y both vary, not heights over a grid");
  return std::move(surfaces.front().heights);
}

}  // namespace

GroundUnit likely_unit(const HeightSource& heights) {
  const std::vector<double>&x = heights.x(), &y = heights.y();
  const auto within = [](const std::vector<double>& at, double most) { return at.front() >= -most && at.back() <= most; };
  const bool fine = x[1] - x[0] <= kWidestStepOfDegrees && y[1] - y[0] <= kWidestStepOfDegrees;
  return fine && within(x, kMostLongitude) && within(y, kMostLatitude) ? GroundUnit::degrees : GroundUnit::same;
}

std::vector<GridSurface> read_surfaces(const std::filesystem::path& file, Warnings& warnings, InputFiles* opened,
                                       const GridChoice& choice) {
  InputFiles unasked;
  InputFiles& files = opened ? *opened : unasked;
  std::vector<std::byte> bytes = read_named_input(file, files);
  const std::string name = shown_input(file);
  if (!is_hgt_name(name)) bytes = as_utf8(std::move(bytes));
  std::vector<GridSurface> surfaces = read_surfaces(bytes, name, warnings, file == "-" ? "" : file, &files, choice);
  for (GridSurface& surface : surfaces) {
    if (surface.heights) surface.heights = thinned_heights(std::move(surface.heights), choice, warnings);
  }
  return surfaces;
}

std::unique_ptr<HeightSource> read_grid(const std::filesystem::path& file, Warnings& warnings, InputFiles* opened,
                                        const GridChoice& choice) {
  return heights_alone(read_surfaces(file, warnings, opened, choice), shown_input(file));
}

std::unique_ptr<HeightSource> read_grid(std::span<const std::byte> bytes, const std::string& name, Warnings& warnings,
                                        const std::filesystem::path& file, InputFiles* opened, const GridChoice& choice) {
  return heights_alone(read_surfaces(bytes, name, warnings, file, opened, choice), name);
}

std::vector<GridSurface> read_surfaces(std::span<const std::byte> bytes, const std::string& name, Warnings& warnings,
                                       const std::filesystem::path& file, InputFiles* opened, const GridChoice& choice) {
  if (bytes.empty()) throw InputError(name, "is empty");
  if (const std::optional<UnpackedFile> inner = unpacked_grid(bytes, name)) {
    if (inner->bytes.empty()) throw InputError(name, "holds an empty file");
    if (is_hgt_name(inner->name)) return alone(read_hgt_grid(inner->bytes, inner->name, warnings));
    if (unpacked(inner->bytes, name)) throw InputError(name, "is an archive within an archive: unpack it");
    return read_surfaces(inner->bytes, name, warnings, {}, nullptr, choice);
  }
  if (auto heights = read_picture(bytes, name, warnings, file, opened, choice)) return alone(std::move(heights));
  const std::string_view chars(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (auto arrays = read_arrays(bytes, name, choice.data_set.value_or(0), kWanted, warnings)) {
    std::vector<GridSurface> surfaces;
    surfaces.push_back(surface_of_arrays(std::move(*arrays), name, choice, warnings));
    return surfaces;
  }
  if (const auto format = foreign_data_format(chars)) throw InputError(name, *format);
  if (chars.starts_with("ply")) {
    ReadReport counts;
    Scene cloud = read_ply({{bytes, name}, counts, warnings});
    if (cloud.faces.empty() && !cloud.vertices.empty())
      return alone(surface_of_cloud(std::move(cloud.vertices), choice, name, warnings));
  }
  refuse_models(bytes, name, kWanted);
  if (!may_be_text(chars)) {
    throw InputError(
        name,
        "is not a known grid format (text tables, ESRI ASCII grid, PGM, PNG, GeoTIFF, Surfer, npy, netCDF, MATLAB, JSON)");
  }
  if (!is_esri_grid(as_text(bytes, name))) return read_text_surfaces(bytes, name, warnings, choice);
  std::unique_ptr<HeightSource> heights = read_esri_grid(bytes, name, warnings);
  heights->set_unit(likely_unit(*heights));
  return alone(std::move(heights));
}

std::optional<double> height_in(std::string_view word) {
  const CellValue cell = cell_value(word, {});
  return cell.kind == CellKind::word ? std::nullopt : std::optional(cell.value);
}

std::vector<double> counted_positions(std::size_t n) {
  std::vector<double> positions(n);
  for (std::size_t i = 0; i < n; ++i) positions[i] = static_cast<double>(i);
  return positions;
}

void check_counts(std::size_t columns, std::size_t rows, const std::string& name) {
  if (columns >= 2 && rows >= 2) return;
  const auto counted = [](std::size_t n, const std::string& what) {
    return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
  };
  throw InputError(
      name, "has " + counted(columns, "column") + " and " + counted(rows, "row") + "; a grid has two of each or more");
}

void check_positions(std::span<const double> positions, const char* axis, const std::string& name) {
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (!std::isfinite(positions[i]))
      throw InputError(name, std::string("has a position ") + axis + " that is not a finite number");
    if (i > 0 && !(positions[i - 1] < positions[i])) {
      throw InputError(name, std::string("positions ") + axis + " do not ascend: number " + std::to_string(i + 1) +
                                 " is not above the one before it");
    }
  }
}

}  // namespace ligne
