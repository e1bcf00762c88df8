#include "picture/stream/streamed_model.hpp"

#include <algorithm>
#include <utility>

#include "files/message_text.hpp"
#include "geometry/degrees.hpp"
#include "picture/errors.hpp"
#include "picture/marks/axes.hpp"
#include "picture/products.hpp"
#include "picture/stream/stream_passes.hpp"
#include "picture/stream/streamed_vertices.hpp"
#include "scene/clean/named_objects.hpp"
#include "visibility/registry.hpp"

namespace ligne {
namespace {

/// Adjustable: memory of a triangle while its model is read and drawn, in bytes.
constexpr double kBytesPerTriangle = 160;
/// Parts of the available memory: for a model that is read as a whole, and for the squares of a streamed one.
constexpr double kPartForModel = 0.5, kPartForSquares = 1.0 / 16;
constexpr double kMostSquares = 4'000'000;

/// Whether all classes are those of edges and intersections. The others need whole surfaces or hidden faces.
bool can_be_found(LineClasses classes) {
  const LineClasses known{(1u << kEdgeClassCount) - 1};
  return (classes.bits & ~known.bits) == 0;
}

/// The bounds and the view of the whole model, from the few triangles that reach farthest.
struct StreamedView {
  std::vector<std::uint32_t> triangles{};
  Placement placement{};
  double largest = 0, near_mm = 0, far_mm = 0;
};

std::optional<StreamedView> find_view(const TriangleFile& file, const PictureRequest& picture,
                                      const StreamedBounds& bounds) {
  StreamedView view{.triangles = bounds.triangles(), .largest = bounds.largest_coordinate()};
  const Camera camera = camera_of(picture.view, scene_of_triangles(file, view.triangles));
  const StreamedExtent extent = find_extent(file, camera);
  for (const std::uint32_t t : extent.triangles()) view.triangles.push_back(t);
  std::sort(view.triangles.begin(), view.triangles.end());
  view.triangles.erase(std::unique(view.triangles.begin(), view.triangles.end()), view.triangles.end());
  const Scene frame = scene_of_triangles(file, view.triangles);
  const Rect seen = projected_extent(frame, camera), all = extent.rect();
  if (!extent.in_view || seen.min != all.min || seen.max != all.max) return std::nullopt;
  view.placement = place_with_axes({}, {camera, picture.page.extent.value_or(seen), frame.unit_mm}, picture.page,
                                   picture.axes, picture.heading)
                       .placement;
  const auto depth_mm = [&](double distance) {
    const double s = view.placement.view.scale, d = camera.target_distance;
    return camera.perspective ? s * d * (distance - d) / distance : s * distance;
  };
  view.near_mm = depth_mm(-extent.farthest[5].value);
  view.far_mm = depth_mm(extent.farthest[4].value);
  return view;
}

}  // namespace

std::string why_not_streamed(const ModelRequest& model, const PictureRequest& picture) {
  const LineRequest& lines = picture.lines;
  if (model.files.size() != 1) return "there are several models";
  if (lines.quality != Quality::exact) return "clear lines need the whole surface: --quality exact does not";
  if (lines.hidden != HiddenLines::none) return "hidden lines need all hidden parts";
  if (lines.method && lines.method != find_method("appel")) return "only method appel draws streamed models";
  if (lines.cull) return "--cull needs whole solids";
  if (lines.profiles() != ProfileKind::off) return "profiles depend on the faces behind them";
  if (!can_be_found(lines.classes)) return "--edges names lines that are not edges";
  if (needs_regions(picture) || picture.gray_faces) return "streamed models can be drawn as lines only";
  if (picture.output.format == OutputFormat::json) return "JSON output contains face numbers";
  if (picture.output.group_objects || !picture.output.colors.empty() || !picture.plotter.asked_pens.pen_of_object.empty() ||
      model.parts.is_requested()) {
    return "streaming makes a single part";
  }
  if (model.weld_distance.value_or(0) > 0) return "--weld needs all vertices";
  if (model.subdivision) return "--subdivide needs whole meshes";
  if (model.merge_coplanar) return "--merge-coplanar needs whole faces";
  if (picture.view.camera) return "such files have no camera";
  return {};
}

std::unique_ptr<TriangleFile> file_to_stream(Streaming streaming, const ModelRequest& model, const PictureRequest& picture) {
  if (streaming == Streaming::off) return nullptr;
  std::string why = why_not_streamed(model, picture);
  std::unique_ptr<TriangleFile> file;
  if (why.empty()) file = TriangleFile::open(model.files.front(), why);
  if (streaming == Streaming::on) {
    if (!file) throw RequestError("stream", printable(model.files.front(), kLongestPath) + " can not be streamed: " + why);
    return file;
  }
  if (!file) return nullptr;
  const double need = kBytesPerTriangle * static_cast<double>(file->triangle_count());
  return need > kPartForModel * picture.memory.bytes ? std::move(file) : nullptr;
}

std::optional<StreamedModel> stream_model(TriangleFile& file, const PictureRequest& picture, RunReport& run,
                                          std::string& why) {
  const Stage stage{"read", printable(file.name(), kLongestPath)};
  StreamedBounds bounds;
  bool triangles_alone = false;
  timed(run.stages, stage, [&] {
    triangles_alone = file.check();
    if (triangles_alone) bounds = find_bounds(file);
  });
  if (!triangles_alone) {
    why = "it has faces that are not triangles";
    return std::nullopt;
  }
  if (file.triangle_count() - bounds.degenerate < kFewestStreamedFaces) {
    why = "it has fewer than " + std::to_string(kFewestStreamedFaces) + " faces";
    return std::nullopt;
  }
  const auto view = timed(run.stages, "find view", [&] { return find_view(file, picture, bounds); });
  if (!view) {
    why = "part of it is out of view";
    return std::nullopt;
  }
  const StreamFacets facets(view->placement.view, file.precision(), view->largest, view->near_mm, view->far_mm);
  const bool blanks = !picture.lines.studied().has(LineClass::mesh);
  const double most =
      std::min(kMostSquares, picture.memory.bytes * kPartForSquares / static_cast<double>(PageLayers::kBytesPerSquare));
  auto layers = timed(run.stages, "find covers", [&] {
    const PageSquares squares = choose_squares(file, facets, view->placement.picture, most);
    return find_page_layers(file, facets, squares, blanks, sine_cosine_degrees(picture.lines.crease_degrees).cosine);
  });
  if (!layers) {
    why = "part of it is out of view";
    return std::nullopt;
  }
  StreamedModel streamed;
  timed(run.stages, "find candidates", [&] {
    std::vector<std::uint32_t> needed = find_needed(file, facets, *layers, view->triangles);
    const std::string blank = std::to_string(layers->blank_count());
    streamed.blank = std::make_shared<const OccludedCells>(layers->take_blank());
    layers.reset();
    streamed.models.scene = scene_of_needed(file, facets, std::move(needed));
    run.choices.emplace_back("streaming", std::to_string(streamed.models.scene.faces.size()) + " of " +
                                              std::to_string(file.triangle_count()) + " triangles stored, " + blank +
                                              " of " + std::to_string(streamed.blank->squares.count()) + " squares blank");
  });
  ModelFile& model = streamed.models.files.emplace_back();
  model.name = file.name();
  model.report = file.report();
  model.warnings.add("faces with fewer than three distinct vertices dropped", bounds.degenerate);
  streamed.models.object_names.push_back(object_name(streamed.models.scene.objects.front(), 0));
  return streamed;
}

}  // namespace ligne
