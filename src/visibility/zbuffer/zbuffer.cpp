#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "base/parallel.hpp"
#include "drawing/result_models.hpp"
#include "view/projected_scene.hpp"
#include "view/tolerances.hpp"
#include "visibility/common/cell_grid.hpp"
#include "visibility/common/clock.hpp"
#include "visibility/edges/line_strokes.hpp"
#include "visibility/methods.hpp"
#include "visibility/penetration/intersections.hpp"
#include "visibility/raster/depth_buffer.hpp"
#include "visibility/raster/scan_conversion.hpp"
#include "visibility/zbuffer/edge_sampling.hpp"
#include "visibility/zbuffer/kept_buffer.hpp"

// Phases: (1) fill the buffer, face by face and row by row, (2) find lines of intersection, if wanted, (3) sample lines
// against the buffer. See docs/methods/zbuffer.md.

namespace ligne {
namespace {

using namespace zbuffer;

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

/// Adds the transparent faces of a scene to the pixels of its opaque ones: PixelModel::layers and in_front. A face is in
/// front of the visible face if its stored depth is smaller, or equal with a lower number; transparent faces are sorted
/// likewise. Changes nothing if the scene has no transparent face. O(n + p log p) for p pixels of transparent faces.
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

constexpr unsigned kRows = 2048, kMostRows = 16'384;
constexpr unsigned kFewestBits = 4, kMostBits = 24;
constexpr std::string_view kFillingNames[] = {"table", "fixed"};

constexpr MethodParameter kParameters[] = {
    {"lines", "N", "rows of pixels over the height of the page", "2048", {}, 1, kMostRows},
    experiment({"filling", "table|fixed", "how to fill: active edge tables, or triangles in fixed-point numbers", "table",
                kFillingNames}),
    experiment({"depth-bits", "N", "integer depths of N bits (default: floating point)", "", {}, kFewestBits, kMostBits}),
};

/// Shortest part of a line that is drawn, in pixels: a part within two squares of pixels is below the resolution.
constexpr double kShortestPixels = 2;

/// The scale of stored depths: from the near plane (in parallel projection: from the nearest point) to the farthest
/// point of the scene.
DepthScale scale_of(const ProjectedScene& scene, const VisibilityOptions& options) {
  const auto bits = options.settings.count("depth-bits");
  if (!bits || scene.triangles.empty()) return {};
  double nearest = std::numeric_limits<double>::infinity(), farthest = -nearest;
  for (const Triangle& t : scene.triangles) {
    for (const std::uint32_t v : t.v) {
      nearest = std::min(nearest, scene.vertices[v].z);
      farthest = std::max(farthest, scene.vertices[v].z);
    }
  }
  const View& view = scene.view;
  if (view.camera.perspective) {
    nearest = view.scale * view.camera.target_distance * (1 - view.camera.target_distance / view.near_distance);
  }
  return {nearest, (farthest - nearest) / (std::exp2(*bits) - 1)};
}

DepthBuffer empty_buffer(const ProjectedScene& scene, const VisibilityOptions& options) {
  return {PixelGrid::of(scene.view.window, options.span_lines, options.settings.count("lines"), kRows),
          scale_of(scene, options)};
}

/// The facets without those wholly hidden by the buffer; large facets are always kept.
std::vector<Facet> facets_in_front(const ProjectedScene& scene, const DepthBuffer& buffer,
                                   const std::vector<Facet>& facets) {
  constexpr double kMostPixels = 16;  // adjustable: largest width and height of a facet that is tested
  const PixelPlaces places(buffer.grid(), scene.lattice);
  const auto hidden = [&](const Facet& f) {
    double low_u = std::numeric_limits<double>::infinity(), low_v = low_u, high_u = -low_u, high_v = -low_u;
    for (const std::uint32_t v : f.v) {
      const double u = places.u(scene.vertices[v].p), w = places.v(scene.vertices[v].p);
      low_u = std::min(low_u, std::floor(u));
      high_u = std::max(high_u, std::ceil(u));
      low_v = std::min(low_v, std::floor(w));
      high_v = std::max(high_v, std::ceil(w));
    }
    if (high_u - low_u > kMostPixels || high_v - low_v > kMostPixels) return false;
    if (low_u < 0 || low_v < 0 || high_u >= buffer.grid().width || high_v >= buffer.grid().height) return false;
    for (double v = low_v; v <= high_v; ++v) {
      for (double u = low_u; u <= high_u; ++u) {
        const auto column = static_cast<std::uint32_t>(u), row = static_cast<std::uint32_t>(v);
        if (f.z_near <= buffer.hiding_depth(column, row)) return false;
      }
    }
    return true;
  };
  std::vector<std::uint8_t> left_out(facets.size());
  parallel_for(facets.size(), [&](std::size_t i) { left_out[i] = hidden(facets[i]); });
  std::vector<Facet> kept;
  for (std::size_t i = 0; i < facets.size(); ++i) {
    if (!left_out[i]) kept.push_back(facets[i]);
  }
  return kept;
}

/// Finds intersections; hidden ones only if hidden strokes are wanted.
std::vector<Intersection> intersections_of(const ProjectedScene& scene, const DepthBuffer& buffer, const Facets& facets,
                                           double coincidence_steps, bool hidden_too) {
  if (!scene.with_intersections) return {};
  CellGrid::Options options{.margin_steps = coincidence_steps + 1, .drop_hidden = !hidden_too};
  const std::vector<Facet> searched = hidden_too ? facets.facets : facets_in_front(scene, buffer, facets.facets);
  return find_intersections(scene, searched, CellGrid(scene, searched, options), options.margin_steps);
}

VisibilityResult zbuffer_visibility(const ProjectedScene& scene, const VisibilityOptions& options) {
  VisibilityResult result;
  Statistics& statistics = result.statistics;
  const double step = scene.lattice.step_mm;
  const double coincidence_steps = coincidence_mm(scene) / step;
  Clock clock;

  // 1. The buffer.
  const auto faces = static_cast<std::uint32_t>(scene.model->faces.size());
  const auto* earlier = dynamic_cast<const KeptBuffer*>(options.earlier);
  if (earlier && !earlier->fits(scene.view, faces)) earlier = nullptr;
  DepthBuffer buffer = earlier ? earlier->buffer() : empty_buffer(scene, options);
  const std::uint32_t painted_before = earlier ? earlier->faces() : 0;
  const PaintCounts counts = buffer.add_from(painted_before, scene, options.settings.choice("filling", Filling::table));
  statistics.time("buffer", clock.lap());

  // 2. Intersections.
  const Facets facets = make_facets(scene, coincidence_steps);
  const std::vector<Intersection> intersections =
      intersections_of(scene, buffer, facets, coincidence_steps, options.hidden_strokes);
  statistics.time("intersections", clock.lap());

  // 3. Lines.
  const EdgeSampling sampling(buffer, scene.lattice, scene.view.window);
  const auto sample = [&]() -> LineVisibility {
    return [&sampling](std::size_t, const PageLine& line, std::vector<LinePart>& parts) {
      sampling.find(line, parts);
      return true;
    };
  };
  LineStrokes strokes(scene, facets, options.hidden_strokes, kShortestPixels * buffer.grid().pixel_mm / step);
  strokes.add_edges(sample, options.progress);
  strokes.add_intersections(intersections, sample);
  result.strokes = strokes.take();
  statistics.time("lines", clock.lap());
  if (options.keep == Keep::for_more_objects) result.kept = std::make_shared<KeptBuffer>(buffer, scene.view, faces);
  if (options.wanted & kPixels) {
    const DepthScale scale = buffer.scale();
    result.pixels = buffer.take_pixels();
    if (options.with_transparent_faces) add_transparent_faces(scene, scale, *result.pixels);
    statistics.time("pixels", clock.lap());
  }

  statistics.count("columns", buffer.grid().width);
  statistics.count("rows", buffer.grid().height);
  if (earlier) statistics.count("faces already in the buffer", painted_before);
  statistics.count("faces painted", counts.faces);
  statistics.count("triangles in them", counts.triangles);
  statistics.count("faces that cover no pixel centre", counts.small);
  statistics.count("depths compared", counts.tests);
  statistics.count("of these, nearer", counts.writes);
  statistics.count("candidate edges", scene.edges.size());
  statistics.count("intersection segments", intersections.size());
  statistics.count("strokes", result.strokes->strokes.size());
  return result;
}

}  // namespace

const Method& zbuffer_method() {
  static const FunctionMethod method(
      {.name = "zbuffer",
       .summary = "the nearest face at every pixel, by scan lines; pictures, and lines accurate to one pixel",
       .products = kStrokes | kPixels,
       .exact = false,
       .paper = "E. Catmull, A subdivision algorithm for computer display of curved surfaces, 1974",
       .tolerance_mm = zbuffer_tolerance_mm(210, kRows),
       .parameters = kParameters,
       .transparency = TransparencyMode::hides_nothing},
      zbuffer_visibility);
  return method;
}

double zbuffer_tolerance_mm(double page_height_mm, unsigned rows) {
  constexpr double kPixels = 2;
  return kPixels * page_height_mm / rows;
}

}  // namespace ligne
