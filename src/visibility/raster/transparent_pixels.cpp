#include "visibility/raster/transparent_pixels.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "visibility/raster/scan_conversion.hpp"

namespace ligne::zbuffer {
namespace {

/// Rows of a band, the work of one task. Adjustable.
constexpr std::uint32_t kBandRows = 64;

/// A transparent face at a pixel.
struct Fragment {
  std::uint32_t pixel;  ///< in its band
  float depth;
  std::uint32_t face;
};

/// Paints bands of rows. Two triangles of a face with a common side share no pixel (PolygonScan).
class BandLayers {
 public:
  BandLayers(const ProjectedScene& scene, const DepthScale& scale, const PixelModel& pixels)
      : scene_(scene),
        scale_(scale),
        pixels_(pixels),
        places_({pixels.corner_mm, pixels.pixel_mm, pixels.width, pixels.height}, scene.lattice) {}

  /// Rows [begin, end) that a triangle may meet.
  std::pair<std::uint32_t, std::uint32_t> rows(const Triangle& t) const {
    double low = pixels_.height, high = 0;
    for (const std::uint32_t v : t.v) {
      const double row = places_.v(scene_.vertices[v].p);
      low = std::min(low, std::floor(row));
      high = std::max(high, std::ceil(row) + 1);
    }
    return {static_cast<std::uint32_t>(std::clamp(low, 0.0, double(pixels_.height))),
            static_cast<std::uint32_t>(std::clamp(high, 0.0, double(pixels_.height)))};
  }

  void begin(std::uint32_t first_row, std::uint32_t end_row) {
    first_row_ = first_row;
    end_row_ = end_row;
    fragments_.clear();
  }

  void add(const Triangle& t) {
    scan_.begin(first_row_, end_row_);
    for (std::size_t k = 0; k < 3; ++k) scan_.add(corner(t.v[k]), corner(t.v[(k + 1) % 3]));
    scan_.scan([&](const PolygonRun& run) {
      const double width = pixels_.width;
      const double from = std::clamp(std::ceil(run.u0), 0.0, width), to = std::clamp(std::ceil(run.u1), 0.0, width);
      if (from >= to) return;
      const double step = (run.z1 - run.z0) / (run.u1 - run.u0);
      for (auto column = static_cast<std::uint32_t>(from); column < to; ++column) {
        add_pixel(run.line, column, scale_.stored(run.z0 + (column - run.u0) * step), t.face);
      }
    });
  }

  /// Writes the lists of the band's pixels, with numbers of `layers`.
  void finish(TransparentLayers& layers, std::vector<std::uint32_t>& in_front) {
    // From back to front, as lists are made.
    std::ranges::sort(fragments_, {}, [](const Fragment& f) { return std::tuple(f.pixel, -f.depth, ~f.face); });
    const std::size_t first = std::size_t{first_row_} * pixels_.width;
    for (const Fragment& f : fragments_) {
      std::uint32_t& list = in_front[first + f.pixel];
      list = layers.over(f.face, list);
    }
  }

 private:
  GridPoint corner(std::uint32_t v) const {
    const ProjectedVertex& vertex = scene_.vertices[v];
    return {places_.u(vertex.p), places_.v(vertex.p), vertex.z};
  }

  void add_pixel(std::uint32_t row, std::uint32_t column, float depth, std::uint32_t face) {
    const std::size_t i = std::size_t{row} * pixels_.width + column;
    if (std::pair(depth, face) > std::pair(pixels_.depth[i], pixels_.face[i])) return;
    fragments_.push_back({(row - first_row_) * pixels_.width + column, depth, face});
  }

  const ProjectedScene& scene_;
  const DepthScale& scale_;
  const PixelModel& pixels_;
  PixelPlaces places_;
  std::uint32_t first_row_ = 0, end_row_ = 0;
  PolygonScan scan_;
  std::vector<Fragment> fragments_;
};

/// The transparent triangles, except those seen edge on, as lists by band.
std::vector<std::vector<Triangle>> triangles_of_bands(const ProjectedScene& scene, const BandLayers& rows,
                                                      std::size_t bands) {
  std::vector<std::vector<Triangle>> lists(bands);
  for (const Triangle& t : scene.triangles) {
    const bool transparent = t.face < scene.face_is_transparent.size() && scene.face_is_transparent[t.face] != 0;
    if (!transparent || scene.is_edge_on(t)) continue;
    const auto [begin, end] = rows.rows(t);
    for (std::uint32_t band = begin / kBandRows; band * kBandRows < end; ++band) lists[band].push_back(t);
  }
  return lists;
}

}  // namespace

void add_transparent_faces(const ProjectedScene& scene, const DepthScale& scale, PixelModel& pixels) {
  const std::size_t bands = block_count(pixels.height, kBandRows);
  const BandLayers all(scene, scale, pixels);
  const std::vector<std::vector<Triangle>> triangles = triangles_of_bands(scene, all, bands);
  if (std::ranges::all_of(triangles, [](const auto& list) { return list.empty(); })) return;
  pixels.in_front.assign(pixels.face.size(), TransparentLayers::kEmptyList);
  std::vector<TransparentLayers> layers(bands);
  const auto rows_of = [&](std::size_t band) {
    const auto first = static_cast<std::uint32_t>(band) * kBandRows;
    return std::pair(first, std::min(pixels.height, first + kBandRows));
  };
  parallel_tasks(bands, [&](std::size_t band) {
    BandLayers in_band = all;
    const auto [first, end] = rows_of(band);
    in_band.begin(first, end);
    for (const Triangle& t : triangles[band]) in_band.add(t);
    in_band.finish(layers[band], pixels.in_front);
  });
  for (std::size_t band = 0; band < bands; ++band) {
    const std::vector<std::uint32_t> numbers = pixels.layers.merge(layers[band]);
    const auto [first, end] = rows_of(band);
    for (std::size_t i = std::size_t{first} * pixels.width; i < std::size_t{end} * pixels.width; ++i) {
      pixels.in_front[i] = numbers[pixels.in_front[i]];
    }
  }
}

}  // namespace ligne::zbuffer
