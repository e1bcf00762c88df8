#include "picture/clear/refined_picture.hpp"

#include <algorithm>
#include <utility>

#include <glm/geometric.hpp>

#include "base/no_index.hpp"
#include "contours/contour_sights.hpp"
#include "picture/drawn_scene.hpp"
#include "picture/products.hpp"

namespace ligne {
namespace {

/// Adjustable: largest distance of the middle of an edge from its surface, in pen widths. More shows as corners of circles.
constexpr double kMostInPens = 0.5;

bool is_of_lines_alone(const PictureRequest& request) {
  const LineRequest& lines = request.lines;
  return lines.quality == Quality::clear && !lines.classes.has(LineClass::mesh) && !has_shape_lines(lines.classes) &&
         !needs_regions(request) && !request.gray_faces && !request.groups && !request.iso && !request.compiled &&
         request.keep == Keep::nothing && !request.earlier && !request.blank;
}

/// Renumbers what a method found on a refined scene.
class GivenNumbers {
 public:
  GivenNumbers(const GivenScene& given, SceneVisibility& found) : given_(given), found_(found) {}

  void renumber() {
    VisibilityResult& result = found_.result;
    if (result.regions) name_faces(*result.regions);
    if (result.order) name_faces(result.order->pieces);
    if (result.spans) name_faces(result.spans->spans);
    if (result.plane) name_faces(result.plane->segments);
    name_faces(found_.details);
    for (SourceEdge& source : result.strokes->intersections) name(source.faces);
    number_edges();
    StrokeModel& strokes = *result.strokes;
    for (Stroke& s : strokes.strokes) s.source = number(s.source);
    for (HiddenPart& part : strokes.hidden_parts) {
      part.source = number(part.source);
      for (std::uint32_t& face : part.faces) name(face);
      std::ranges::sort(part.faces);
      part.faces.erase(std::unique(part.faces.begin(), part.faces.end()), part.faces.end());
    }
    std::ranges::stable_sort(strokes.hidden_parts, {}, &HiddenPart::source);
    found_.first_detail = shifted(found_.first_detail);
    strokes.edge_count = shifted(strokes.edge_count);
    found_.edges = given_.edges;
  }

 private:
  void name(std::uint32_t& face) const {
    if (face != kNone) face = given_.refined.face_of[face];
  }
  void name(std::array<std::uint32_t, 2>& faces) const {
    for (std::uint32_t& face : faces) name(face);
  }
  template <class Things>
  void name_faces(Things& things) const {
    for (auto& thing : things) name(thing.face);
  }

  std::uint32_t shifted(std::uint32_t number) const {
    return static_cast<std::uint32_t>(number + given_.edges.size() - given_.refined.edge_of.size());
  }
  std::uint32_t number(std::uint32_t source) const {
    return source < number_of_.size() ? number_of_[source] : shifted(source);
  }

  /// Whether the ends of a line are those of a given edge: vertices of refined surfaces may have moved.
  bool is_in_place(const SourceEdge& line, std::uint32_t e) const {
    const Point3 &p = given_.scene.vertices[given_.edges[e].v0], &q = given_.scene.vertices[given_.edges[e].v1];
    return (line.ends[0] == p && line.ends[1] == q) || (line.ends[0] == q && line.ends[1] == p);
  }

  /// Numbers the edges of the refined scene that have strokes: whole given edges by their own number, others as lines that
  /// are no edges.
  void number_edges() {
    StrokeModel& strokes = *found_.result.strokes;
    const std::vector<std::uint32_t>& edge_of = given_.refined.edge_of;
    std::vector<std::uint32_t> pieces(given_.edges.size(), 0);
    for (const std::uint32_t e : edge_of) {
      if (e != kNone) ++pieces[e];
    }
    number_of_.assign(edge_of.size(), kNone);
    const std::uint32_t first = shifted(strokes.edge_count);
    const auto add = [&](std::uint32_t source) {
      if (source >= edge_of.size() || number_of_[source] != kNone) return;
      const std::uint32_t e = edge_of[source];
      SourceEdge line = found_.source(given_.refined.scene, source);
      if (e != kNone && pieces[e] == 1 && is_in_place(line, e)) {
        number_of_[source] = e;
        return;
      }
      name(line.faces);
      number_of_[source] = first + static_cast<std::uint32_t>(strokes.intersections.size());
      strokes.intersections.push_back(line);
    };
    for (const Stroke& s : strokes.strokes) add(s.source);
    for (const HiddenPart& part : strokes.hidden_parts) add(part.source);
  }

  const GivenScene& given_;
  SceneVisibility& found_;
  std::vector<std::uint32_t> number_of_;  ///< per edge of the refined scene that has a stroke: its number among the sources
};

}  // namespace

std::shared_ptr<GivenScene> refine_on_page(const Scene& scene, const Topology& topology, const View& view,
                                           const PictureRequest& request, Creases& creases) {
  if (!is_of_lines_alone(request) || creases.lines.empty()) return nullptr;
  const auto unit_mm = [&](const Point3& p) {
    if (view.camera.perspective && camera_coordinates(view.camera, p).z < view.near_distance) return 0.0;
    return glm::length(page_direction(view, p, view.camera.right));
  };
  Patches patches;  // for the names of surfaces; edges are classified already
  patches.list = creases.patches.list;
  patches.patch_of = creases.patches.patch_of;
  std::optional<RefinedScene> refined =
      refine_scene(scene, topology, {kMostInPens * request.page.pen_width_mm, unit_mm}, creases);
  if (!refined) return nullptr;
  return std::make_shared<GivenScene>(GivenScene{scene, {}, std::move(patches), std::move(*refined)});
}

DrawnParts on_given_scene(DrawnParts parts) {
  const std::shared_ptr<const GivenScene> given = parts.prepared.given;
  if (!given) return parts;
  if (parts.has_edges) GivenNumbers(*given, parts.found).renumber();
  if (!parts.patches.of_face.empty()) {
    std::vector<std::uint32_t> of_face(given->scene.faces.size(), 0);
    for (std::size_t f = 0; f < parts.patches.of_face.size(); ++f) {
      of_face[given->refined.face_of[f]] = parts.patches.of_face[f];
    }
    parts.patches.of_face = std::move(of_face);
  }
  PreparedScene prepared = with_scene(std::move(parts.prepared), given->scene);
  prepared.patches = given->patches;
  prepared.given = nullptr;
  return {std::move(prepared), std::move(parts.found), std::move(parts.hatching), std::move(parts.patches), parts.has_edges};
}

}  // namespace ligne
