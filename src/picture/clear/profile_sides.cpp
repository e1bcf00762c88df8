/// The test of what is visible beside strokes, for profiles.

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "picture/clear/source_lines.hpp"
#include "picture/clear/tidy_strokes.hpp"
#include "scene/clean/named_objects.hpp"
#include "view/tolerances.hpp"
#include "visibility/edges/nearest_along.hpp"

namespace ligne {
namespace {

/// Distance of the tested line from the stroke, in multiples of the distance within which lines coincide.
constexpr double kBesideCoincidences = 4;
/// Narrowest gap through which something is visible, in pen widths. Ink fills narrower gaps.
constexpr double kLeastGapInPens = 0.25;
/// Least depth of another object behind the stroke, in pen widths. A nearer object touches.
constexpr double kLeastDepthInPens = 1;

/// The lines on one side of a stroke along which visibility is tested.
struct Side {
  LineOnPage close, off;
  std::vector<StrokePart> free{{0, 1}};
};

/// Unit vector at right angles to from-to; zero for a point.
Point2 across(LatticePoint from, LatticePoint to) {
  const Point2 d = offset(from, to);
  const double size = std::hypot(d.x, d.y);
  return size > 0 ? Point2{-d.y / size, d.x / size} : Point2{0, 0};
}

std::vector<StrokePart> common_parts(const std::vector<StrokePart>& a, const std::vector<StrokePart>& b) {
  std::vector<StrokePart> common;
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    const StrokePart part{std::max(a[i].from, b[j].from), std::min(a[i].to, b[j].to)};
    if (part.from < part.to) common.push_back(part);
    a[i].to < b[j].to ? ++i : ++j;
  }
  return common;
}

void add_part(std::vector<StrokePart>& parts, double from, double to) {
  if (!parts.empty() && parts.back().to == from) {
    parts.back().to = to;
  } else if (from < to) {
    parts.push_back({from, to});
  }
}

/// Makes the lines beside strokes.
class Sides {
 public:
  Sides(const StrokeModel& model, const Scene& scene, const ProjectedScene& projected, const SourceLines& sources,
        const ContourSources& contours, double pen_width_mm)
      : model_(model),
        scene_(scene),
        projected_(projected),
        sources_(sources),
        contours_(contours),
        beside_(std::max(kBesideCoincidences * coincidence_mm(projected) / projected.lattice.step_mm, kLeastSteps)),
        gap_(std::max(kLeastGapInPens * pen_width_mm / projected.lattice.step_mm, beside_)) {}

  /// Adds the sides of a stroke on the mesh on which none of its faces lies, or the free side of a contour.
  void add(const Stroke& stroke, std::vector<Side>& sides) const {
    if (stroke.source >= contours_.first && stroke.source - contours_.first < contours_.lines.size()) {
      if (const auto side = free_side(stroke)) sides.push_back(*side);
      return;
    }
    if (stroke.line_class == LineClass::intersection) return;  // its faces lie on all sides
    const Point2 out = across(stroke.from, stroke.to);
    const auto faces = sources_.faces(stroke);
    const std::array covered{side_of(faces[0], stroke), side_of(faces[1], stroke)};
    for (const double sign : {1.0, -1.0}) {
      if (covered[0] == sign || covered[1] == sign) continue;
      sides.push_back({{moved(stroke.from, sign * beside_ * out), moved(stroke.to, sign * beside_ * out)},
                       {moved(stroke.from, sign * gap_ * out), moved(stroke.to, sign * gap_ * out)}});
    }
  }

 private:
  static constexpr double kLeastSteps = 4;  ///< lattice steps; more than the rounding errors of both ends of two lines

  /// The free side of a contour. Its visibility was computed on a line beyond the outline of the mesh; that line is
  /// tested.
  std::optional<Side> free_side(const Stroke& stroke) const {
    const std::uint32_t e = sources_.candidate(contours_.lines[stroke.source - contours_.first]);
    if (e == kNone) return {};
    const ProjectedEdge& edge = projected_.edges[e];
    const std::array<double, 2> part = projected_.edge_parts.empty() ? std::array{0.0, 1.0} : projected_.edge_parts[e];
    const LatticePoint p0 = projected_.vertices[edge.v0].p, p1 = projected_.vertices[edge.v1].p;
    const auto at = [&](double t) {
      const double u = std::clamp((t - part[0]) / (part[1] - part[0]), 0.0, 1.0);
      return moved(p0, u * offset(p0, p1));
    };
    const std::array close{at(stroke.t_from), at(stroke.t_to)};
    // That line lies beside the segment on the mesh. The curve that is drawn may lie beyond both.
    const std::array<Point3, 2>& ends = model_.intersections[stroke.source - model_.edge_count].ends;
    const LatticePoint m0 = on_page(ends[0]), m1 = on_page(ends[1]);
    Point2 out = across(m0, m1);
    if (glm::dot(out, offset(m0, p0) + offset(m1, p1)) < 0) out = -1.0 * out;
    return Side{close, {moved(close[0], gap_ * out), moved(close[1], gap_ * out)}};
  }

  /// The side of an edge of the face on which the face lies: 1 for the side of across(), -1 for the other. 0 if it lies
  /// on both sides, or is so narrow that the tested line lies beyond it.
  double side_of(std::uint32_t face, const Stroke& stroke) const {
    if (face == kNone) return 0;
    const View& view = projected_.view;
    const Point2 from = projected_.lattice.to_mm(stroke.from), along = projected_.lattice.to_mm(stroke.to) - from;
    double lowest = 0, highest = 0;
    for (const std::uint32_t v : scene_.faces.contour(face, 0)) {
      const HomogeneousPoint p = to_homogeneous(view, scene_.vertices[v]);
      if (view.camera.perspective && !(p.w > view.near_distance)) return 0;  // the vertex has no place on the page
      const double height = along.x * (p.y / p.w - from.y) - along.y * (p.x / p.w - from.x);
      lowest = std::min(lowest, height);
      highest = std::max(highest, height);
    }
    const double beside_mm = beside_ * projected_.lattice.step_mm, size = std::hypot(along.x, along.y);
    if (highest > beside_mm * size && lowest > -beside_mm * size) return 1;
    return lowest < -beside_mm * size && highest < beside_mm * size ? -1 : 0;
  }

  LatticePoint on_page(const Point3& p) const { return projected_.lattice.snap(page_point(projected_.view, p)); }

  const StrokeModel& model_;
  const Scene& scene_;
  const ProjectedScene& projected_;
  const SourceLines& sources_;
  const ContourSources& contours_;
  double beside_, gap_;  ///< lattice steps
};

/// Distance between the middle of a stroke and the middle of the line close beside it.
double distance_mm(const StrokeModel& model, const Stroke& stroke, const Side& side) {
  const Point2 twice = offset(stroke.from, side.close[0]) + offset(stroke.to, side.close[1]);
  return std::hypot(twice.x / 2, twice.y / 2) * model.lattice.step_mm;
}

/// Adds the part of a stretch on which the visible facet lies more than `least_mm` behind the stroke.
void add_behind(std::vector<StrokePart>& parts, const Stroke& stroke, const SeenStretch& stretch, const Facet& facet,
                const ProjectedScene& projected, double least_mm) {
  // The distance of the facet's plane behind the stroke is linear along it.
  const auto behind = [&](double t) {
    const double x = stroke.from.x + t * (double(stroke.to.x) - stroke.from.x);
    const double y = stroke.from.y + t * (double(stroke.to.y) - stroke.from.y);
    const double z = stroke.z_from + t * (double(stroke.z_to) - stroke.z_from);
    return plane_depth(facet, projected.vertices, x, y) - z - least_mm;
  };
  const double from = behind(stretch.from), to = behind(stretch.to);
  if (from <= 0 && to <= 0) return;
  const double change = from > 0 && to > 0 ? 0 : stretch.from + from / (from - to) * (stretch.to - stretch.from);
  add_part(parts, from > 0 ? stretch.from : change, to > 0 ? stretch.to : change);
}

/// The facets that hide the paper: all except faces of clear material, which hide no line either.
std::vector<Facet> candidate_facets(const ProjectedScene& projected) {
  std::vector<Facet> facets = make_facets(projected, 0).facets;
  if (!projected.face_is_transparent.empty()) {
    std::erase_if(facets, [&](const Facet& f) { return projected.face_is_transparent[f.face] == kClearFace; });
  }
  return facets;
}

}  // namespace

std::vector<FreeParts> free_parts(const StrokeModel& model, const ProjectedScene& projected, const Scene& scene,
                                  const ContourSources& contours, const ProfileStyle& style) {
  const SourceLines sources(model, projected);
  const Sides sides_of(model, scene, projected, sources, contours, style.pen_width_mm);
  const std::vector<Stroke>& strokes = model.strokes;
  std::vector<std::vector<Side>> sides(strokes.size());
  parallel_blocks(sides.size(), kSearchBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (is_seen(strokes[i]) && is_edge(strokes[i]) && strokes[i].from != strokes[i].to) sides_of.add(strokes[i], sides[i]);
    }
  });
  const std::vector<Facet> facets = candidate_facets(projected);
  const ObjectOfFace object_of(scene);
  const auto owns = [&](const Stroke& stroke, std::uint32_t face) {
    const std::uint32_t object = object_of(face);
    return object == object_of(sources.faces(stroke)[0]) || object == object_of(sources.faces(stroke)[1]);
  };
  // Tests the farther line only where the close one is free.
  const auto look = [&](auto line_of) {
    std::vector<LineOnPage> lines;
    for (const auto& of_stroke : sides) {
      for (const Side& side : of_stroke) {
        if (!side.free.empty()) lines.push_back(line_of(side));
      }
    }
    const auto seen = nearest_along(projected.vertices, facets, lines, style.kind == ProfileKind::sheet);
    std::size_t line = 0;
    for (std::size_t i = 0; i < sides.size(); ++i) {
      const Stroke& stroke = strokes[i];
      for (Side& side : sides[i]) {
        if (side.free.empty()) continue;
        std::vector<StrokePart> free;
        for (const SeenStretch& stretch : seen[line]) {
          if (stretch.facet == kNone) {
            add_part(free, stretch.from, stretch.to);
          } else if (style.kind == ProfileKind::parts && !owns(stroke, facets[stretch.facet].face)) {
            add_behind(free, stroke, stretch, facets[stretch.facet], projected, kLeastDepthInPens * style.pen_width_mm);
          }
        }
        side.free = common_parts(side.free, free);
        ++line;
      }
    }
  };
  look([](const Side& side) { return side.close; });
  look([](const Side& side) { return side.off; });
  std::vector<FreeParts> free(sides.size());
  for (std::size_t i = 0; i < sides.size(); ++i) {
    for (const Side& side : sides[i]) {
      free[i].parts.insert(free[i].parts.end(), side.free.begin(), side.free.end());
      free[i].off_mm = std::max(free[i].off_mm, distance_mm(model, strokes[i], side));
    }
    unite(free[i].parts);
  }
  return free;
}

}  // namespace ligne
