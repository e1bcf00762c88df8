/// Draws parts whose true lines are known three times: with the creases of a coarse mesh, as that mesh is drawn by default,
/// and by the true lines. docs/patches.md shows the pictures; draw_true_parts FOLDER makes them.

#include "clear/true_comparison.hpp"
#include "clear/true_parts.hpp"
#include "picture/draw_scene.hpp"
#include "picture/models/models.hpp"
#include "plotting/paths/optimize.hpp"

namespace ligne::test {
namespace {

constexpr std::array<std::string_view, 8> kDrawn{"plate", "bar", "angle", "bracket", "flange", "cup", "knob", "pulley"};
constexpr Point3 kSight{-1, 1, -0.8};
constexpr double kWidthMm = 80, kHeightMm = 70, kMarginMm = 4, kPenMm = 0.25;
/// Facets to a turn of the drawn mesh, and of the one that tells what is hidden.
constexpr int kFacets = 16, kFineFacets = 960;
/// Length of the pieces that are seen or hidden as a whole.
constexpr double kStepMm = 0.04;
/// Faces that hide a line lie nearer to the viewer by more than this. It is more than the depth at which the fine mesh lies
/// behind an outline: the root of twice the radius and the sag, a 19,000th of the radius.
constexpr double kHiddenMm = 0.3;

/// The layer of a visible true line.
std::string_view layer_of(const TruePoint& point, const Viewer& viewer) {
  const Point3 to_viewer = viewer.from(point.at);
  const bool first = glm::dot(point.normals[0], to_viewer) > 0, second = glm::dot(point.normals[1], to_viewer) > 0;
  if (point.kind == TrueLine::outline || first != second) return "outline";
  return point.kind == TrueLine::tangent ? "tangent" : "crease";
}

/// The visible true lines of a part, placed as another drawing of it.
Drawing true_drawing(const TruePart& part, const Scene& fine, const View& view) {
  const Hiding hiding(fine, view);
  const Viewer viewer{glm::normalize(to_eye(view.camera, {0, 0, 0})), false};
  constexpr double kSamePlaceMm = 1e-6;
  std::map<std::string_view, Polylines> lines;
  Point3 last(std::numeric_limits<double>::infinity());
  std::string_view last_layer;
  for (const TruePoint& point : true_lines(part, viewer, kStepMm / view.scale)) {
    const Point3 from = point.at - 0.5 * point.along, to = point.at + 0.5 * point.along, at = hiding.on_page(point.at);
    if (hiding.hides(Point2(at), at.z - kHiddenMm)) continue;
    const std::string_view layer = layer_of(point, viewer);
    Polylines& of_layer = lines[layer];
    if (layer == last_layer && glm::distance(from, last) < 1e-9) {
      of_layer.points.push_back(Point2(hiding.on_page(to)));
      ++of_layer.begin.back();
    } else {
      of_layer.add(std::array{Point2(hiding.on_page(from)), Point2(hiding.on_page(to))});
    }
    last = to;
    last_layer = layer;
  }
  Drawing drawing;
  for (const std::string_view layer : {"tangent", "crease", "outline"})
    drawing.layers.push_back({std::string(layer), join_near_ends(lines[layer], kSamePlaceMm)});
  return drawing;
}

void write(const std::filesystem::path& file, std::string svg) {
  // White paper, so that pictures can be read on dark screens.
  svg.insert(svg.find(">\n", svg.find("<svg")) + 2, "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n");
  std::ofstream(file, std::ios::binary) << svg;
}

void draw(const TruePart& part, const std::filesystem::path& folder) {
  const std::filesystem::path mesh = folder / (part.name + ".stl");
  const auto scene_of = [&](int facets) {
    write_mesh(part, facets, mesh);
    Scene scene = load_models({.files = {mesh.string()}}).scene;
    std::filesystem::remove(mesh);
    return scene;
  };
  const Scene scene = scene_of(kFacets), fine = scene_of(kFineFacets);
  PictureRequest request;
  request.view.direction = kSight;
  request.page.size = {Page{kWidthMm, kHeightMm, kMarginMm}, true};
  request.page.margin_mm = kMarginMm;
  request.page.pen_width_mm = kPenMm;
  const auto file = [&](std::string_view kind) { return folder / ("true-" + part.name + std::string(kind) + ".svg"); };
  RunReport run;
  const DrawnScene drawn = draw_lines(scene, request, run);
  write(file(""), drawn.write(run).bytes);
  const Drawing truth = true_drawing(part, fine, drawn.prepared().view());
  const PlotOptions style = plot_options(request, drawn.prepared().around.placement.page);
  write(file("-truth"), write_picture(truth, style, {}, {OutputFormat::svg}, run).bytes);
  request.lines.quality = Quality::exact;
  write(file("-exact"), draw_lines(scene, request, run).write(run).bytes);
}

}  // namespace
}  // namespace ligne::test

int main(int argc, char** argv) {
  using namespace ligne::test;
  if (argc != 2) {
    std::cerr << "usage: draw_true_parts FOLDER\n";
    return 2;
  }
  for (const TruePart& part : true_parts())
    if (std::ranges::count(kDrawn, part.name) > 0) draw(part, argv[1]);
}
