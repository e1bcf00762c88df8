#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "view/tolerances.hpp"
#include "visibility/common/clock.hpp"
#include "visibility/common/facet.hpp"
#include "visibility/edges/line_strokes.hpp"
#include "visibility/methods.hpp"
#include "visibility/order/paint_pieces.hpp"
#include "visibility/painter/paint_sequence.hpp"
#include "visibility/raster/depth_buffer.hpp"

// Phases: (1) facets and their grid, (2) the order, (3) lines: each is painted with the later of its faces, and later
// faces cover it, (4) pixels. See docs/methods/painter.md.

namespace ligne {
namespace {

using namespace painter;

constexpr unsigned kRows = 2048;
constexpr std::string_view kSortNames[] = {"mean", "farthest", "resolved"};
constexpr std::string_view kShowNames[] = {"order"};
constexpr MethodParameter kParameters[] = {
    experiment(
        {"depth-sort", "HOW",
         "sort key of the faces: mean or farthest depth; resolved: farthest depth, then pairs ordered by their planes",
         "resolved", kSortNames}),
    {"show", "order", "layer debug: the painting order as numbers", "", kShowNames},
};

/// Finds the parts of lines that remain visible after painting.
class PaintedLines {
 public:
  PaintedLines(const ProjectedScene& scene, const Facets& facets, const CellGrid& grid, const PaintSequence& sequence,
               double coincidence_steps)
      : scene_(scene), facets_(facets), grid_(grid), sequence_(sequence), coincidence_steps_(coincidence_steps) {}

  bool find(const PageLine& line, std::vector<LinePart>& parts) {
    const std::uint32_t place = place_of(line);
    bool near_side = false;
    PageLine nearest = line;  // so that no cell counts as hidden
    nearest.z0 = nearest.z1 = -std::numeric_limits<double>::infinity();
    grid_.for_each_leaf(nearest, [&](const Cell& cell, const CellSquare&, double from, double to) {
      open_.reset(from, to);
      const CellFacet* entry = grid_.list(cell);
      for (std::uint32_t i = 0; i < cell.count && !open_.empty(); ++i) {
        const Facet& facet = facets_.facets[entry[i].facet];
        if (facet.face == line.face0 || facet.face == line.face1) continue;
        open_.take(covered(line, facet, place, near_side));
      }
      if (open_.empty()) return;
      for (const LinePart& part : open_.finish()) append_part(parts, part);
    });
    return true;
  }

 private:
  /// Place of a face in the order. A face seen edge on within the lattice gives kNever, too: it overlaps nothing on the
  /// page, so its place says nothing about its lines.
  std::uint32_t place_of(std::uint32_t face) const {
    const bool thin = face < facets_.face_is_thin.size() && facets_.face_is_thin[face];
    return thin ? PaintSequence::kNever : sequence_.place(face);
  }
  /// The later place of the line's faces; kNever if none is painted.
  std::uint32_t place_of(const PageLine& line) const {
    const std::uint32_t a = place_of(line.face0), b = place_of(line.face1);
    return a == PaintSequence::kNever ? b : b == PaintSequence::kNever ? a : std::max(a, b);
  }

  /// The part of the line that the facet paints over. A painter ignores depth: a later facet covers the line, unless
  /// the line touches it. For lines painted with no face, depth decides.
  HiddenInterval covered(const PageLine& line, const Facet& facet, std::uint32_t place, bool& near_side) const {
    const ProjectedVertex* vertices = scene_.vertices.data();
    if (place == PaintSequence::kNever) {
      return hidden_interval(line, facet, vertices, {open_.from(), open_.to()}, coincidence_steps_, near_side);
    }
    if (sequence_.place(facet.face) < place) {
      // A face with a side along the line covers one side of it and need not overlap the line's own faces on the page.
      // Then any order of these faces is right, and depth decides.
      const HiddenInterval beside =
          hidden_interval(line, facet, vertices, {open_.from(), open_.to()}, coincidence_steps_, near_side);
      return beside.sides == HiddenSides::both ? HiddenInterval{} : beside;
    }
    PageLine farthest = line;
    constexpr double kBehindAll = 1e30;  // mm; large against any depth
    farthest.z0 = farthest.z1 = kBehindAll;
    const HiddenInterval hidden =
        hidden_interval(farthest, facet, vertices, {open_.from(), open_.to()}, coincidence_steps_, near_side);
    if (hidden.sides == HiddenSides::none) return {};
    const FacetFunctions plane(facet, vertices);
    const auto distance = [&](double t) {
      return std::abs(line.z(t) - plane.depth(line.p0.x + t * line.dx, line.p0.y + t * line.dy));
    };
    if (std::max(distance(hidden.from), distance(hidden.to)) <= facet.depth_tolerance) return {};
    return hidden;
  }

  const ProjectedScene& scene_;
  const Facets& facets_;
  const CellGrid& grid_;
  const PaintSequence& sequence_;
  double coincidence_steps_;
  OpenParts open_;
};

/// The finished picture: a depth buffer in which the depth of a face is its place in the order.
PixelModel paint(const ProjectedScene& scene, const PaintSequence& sequence, const VisibilityOptions& options) {
  ProjectedScene flat{.lattice = scene.lattice, .view = scene.view};
  for (const Triangle& t : scene.triangles) {
    const std::uint32_t place = sequence.place(t.face);
    if (place == PaintSequence::kNever) continue;
    const auto v = static_cast<std::uint32_t>(flat.vertices.size());
    for (const std::uint32_t corner : t.v) flat.vertices.push_back({scene.vertices[corner].p, -double(place)});
    flat.triangles.push_back({{v, v + 1, v + 2}, t.face});
  }
  zbuffer::DepthBuffer buffer(zbuffer::PixelGrid::of(scene.view.window, options.span_lines, {}, kRows), {});
  buffer.add(flat, zbuffer::Filling::fixed);
  return buffer.take_pixels();
}

/// The triangles of the faces, in the order of painting.
PaintOrder paint_order(const ProjectedScene& scene, const PaintSequence& sequence) {
  std::vector<std::vector<std::uint32_t>> triangles_at(sequence.faces.size());
  for (std::uint32_t i = 0; i < scene.triangles.size(); ++i) {
    const std::uint32_t place = sequence.place(scene.triangles[i].face);
    if (place != PaintSequence::kNever) triangles_at[place].push_back(i);
  }
  PaintOrder order;
  for (const std::vector<std::uint32_t>& triangles : triangles_at) {
    for (const std::uint32_t i : triangles) {
      const auto& v = scene.triangles[i].v;
      const ProjectedVertex &a = scene.vertices[v[0]], &b = scene.vertices[v[1]], &c = scene.vertices[v[2]];
      const double area = orientation(a.p, b.p, c.p) * scene.lattice.step_mm * scene.lattice.step_mm;
      if (area == 0) continue;
      const Point2 p = scene.lattice.to_mm(a.p), q = scene.lattice.to_mm(b.p), r = scene.lattice.to_mm(c.p);
      // Cramer's rule.
      const double zq = b.z - a.z, zr = c.z - a.z;
      const double gx = (zq * (r.y - p.y) - zr * (q.y - p.y)) / area, gy = (zr * (q.x - p.x) - zq * (r.x - p.x)) / area;
      order.pieces.push_back({scene.triangles[i].face, {{p, q, r}}, {gx, gy, a.z - gx * p.x - gy * p.y}});
    }
  }
  return order;
}

/// Whether the eye may lie on a face: the eye is in the plane of some face, and a part is out of view. Such a face has
/// no place in the order, and where it reaches the eye its lines are in front of all others.
bool eye_is_on_a_face(const ProjectedScene& scene) {
  const bool cut_off = scene.view.camera.perspective && !scene.edge_parts.empty();
  return cut_off && std::ranges::count(scene.face_is_edge_on, std::uint8_t{1}) > 0;
}

std::string why_wrong(const ProjectedScene& scene, const PaintSequence& s) {
  std::string text = eye_is_on_a_face(scene) ? "the eye lies in the plane of a face and a part is out of view" : "";
  const auto add = [&](std::uint64_t count, const char* one, const char* many) {
    if (count > 0) text += (text.empty() ? "" : ", ") + std::to_string(count) + (count == 1 ? one : many);
  };
  add(s.wrong, " pair of faces is painted in the wrong order", " pairs of faces are painted in the wrong order");
  add(s.penetrating, " pair has no right order", " pairs have no right order");
  return text;
}

VisibilityResult painter_visibility(const ProjectedScene& scene, const VisibilityOptions& options) {
  VisibilityResult result;
  Statistics& statistics = result.statistics;
  const double step = scene.lattice.step_mm;
  const double coincidence_steps = coincidence_mm(scene) / step;
  Clock clock;

  // 1. Facets.
  const Facets facets = make_facets(scene, coincidence_steps);
  CellGrid::Options of_grid{.margin_steps = coincidence_steps + 1, .drop_hidden = false};
  const CellGrid grid(scene, facets.facets, of_grid);
  statistics.time("facets", clock.lap());

  // 2. The order.
  const PaintSequence sequence =
      paint_sequence(scene, facets.facets, grid, options.settings.choice("depth-sort", DepthSort::resolved));
  result.unsupported_reason = why_wrong(scene, sequence);
  statistics.time("order", clock.lap());

  // 3. Lines.
  LineStrokes strokes(scene, facets, options.hidden_strokes, kLeastPartMm / step);
  const auto painted = [&]() -> LineVisibility {
    return [lines = PaintedLines(scene, facets, grid, sequence, coincidence_steps)](
               std::size_t, const PageLine& line, std::vector<LinePart>& parts) mutable { return lines.find(line, parts); };
  };
  strokes.add_edges(painted, options.progress);
  result.strokes = strokes.take();
  statistics.time("lines", clock.lap());

  const bool shows = options.settings.has("show");
  if ((options.wanted & kOrder) || shows) {
    result.order = paint_order(scene, sequence);
    if (shows) result.debug_numbers = order_numbers(*result.order);
  }

  // 4. Pixels.
  if (options.wanted & kPixels) {
    result.pixels = paint(scene, sequence, options);
    statistics.time("pixels", clock.lap());
  }

  statistics.count("faces painted", sequence.faces.size());
  statistics.count("faces of constant depth", sequence.level);
  statistics.count("pairs that overlap on the page", sequence.overlapping);
  statistics.count("resolved by their depths", sequence.by_depths);
  statistics.count("resolved by a plane", sequence.by_planes);
  statistics.count("pairs left in sorted order", sequence.left);
  statistics.count("faces painted to break a cycle", sequence.in_rings);
  statistics.count("pairs in the wrong order", sequence.wrong);
  statistics.count("pairs without a right order", sequence.penetrating);
  statistics.count("candidate edges", scene.edges.size());
  statistics.count("strokes", result.strokes->strokes.size());
  return result;
}

}  // namespace

const Method& painter_method() {
  static const FunctionMethod method(
      {.name = "painter",
       .summary = "faces sorted by depth and painted from the farthest to the nearest; none is cut",
       .products = kStrokes | kOrder | kPixels,
       .penetration = false,
       .paper =
           "M. E. Newell, R. G. Newell, T. L. Sancha, A solution to the hidden surface problem, 1972 (its simple versions)",
       .parameters = kParameters,
       .only_for = "scenes whose faces the sort orders correctly"},
      painter_visibility);
  return method;
}

}  // namespace ligne
