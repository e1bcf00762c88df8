#include "clear/clear_against_exact.hpp"

#include "picture/draw_scene.hpp"
#include "picture/models/models.hpp"
#include "picture/placement.hpp"

namespace ligne::test {
namespace {

constexpr double kStepMm = 0.1;
constexpr double kCellMm = 1;
/// Edges of roundings bend by no more: creases begin at 30 degrees, or at twice as much where a rounding goes on.
constexpr double kMostBendDegrees = 60;
/// Rounding to the lattice and of the page's coordinates.
constexpr double kRoundingMm = 0.002;

struct Drawn {
  Drawing drawing;
  View view;
};

Drawn draw(const Scene& scene, std::string_view view, Quality quality, bool draws_mesh) {
  PictureRequest request;
  request.lines.quality = quality;
  request.view.named_view = view;
  request.page.pen_width_mm = kPenMm;
  request.page.extent = projected_extent(scene, camera_of(request.view, scene));  // one place for both qualities
  if (draws_mesh) request.lines.classes.add(LineClass::mesh);
  RunReport run;
  const DrawnScene drawn = draw_lines(scene, request, run);
  return {drawn.compose(run), drawn.prepared().view()};
}

LoadedModels load(const std::filesystem::path& file, Quality quality) {
  ModelRequest models{.files = {file.string()}};
  models.quality = quality;
  return load_models(models);
}

bool is_feature(std::string_view layer) {
  return layer == "outline" || layer == "border" || layer == "intersection" || layer == "crease";
}

template <class Visit>
void each_segment(const Drawing& drawing, const Visit& visit) {
  for (const Layer& layer : drawing.layers) {
    for (std::size_t i = 0; i < layer.lines.size(); ++i) {
      const std::span<const Point2> line = layer.lines[i];
      for (std::size_t k = 1; k < line.size(); ++k) visit(layer.name, line[k - 1], line[k], k == 1);
    }
  }
}

/// Whether no face lies a little beside a point, in some direction.
bool at_rim(const MeshSags& sags, Point2 p) {
  constexpr int kDirections = 16;
  constexpr double kBesideMm = 0.05;
  for (int k = 0; k < kDirections; ++k) {
    const double turn = 2 * 3.14159265358979323846 * k / kDirections;
    if (!sags.at(p + kBesideMm * Point2(std::cos(turn), std::sin(turn)), kRoundingMm)) return true;
  }
  return false;
}

/// The runs of the drawing's lines at whose points `away` is more than `bound`, both functions of the layer and the point.
template <class Away, class Bound>
std::vector<Run> runs_beyond(const Drawing& drawing, const MeshSags& sags, const Away& away, const Bound& bound) {
  std::vector<Run> runs;
  bool open = false;
  each_segment(drawing, [&](const std::string& layer, Point2 a, Point2 b, bool begins) {
    if (begins) open = false;
    if (open) ++runs.back().segments;
    const double length = glm::length(b - a);
    const int steps = std::max(1, static_cast<int>(std::ceil(length / kStepMm)));
    for (int k = 0; k < steps; ++k) {
      const Point2 from = a + (b - a) * (double(k) / steps), to = a + (b - a) * (double(k + 1) / steps);
      const Point2 p = (from + to) / 2.0;
      const double distance = away(layer, p);
      if (distance <= kPenMm / 2 || distance <= bound(p)) {
        open = false;
        continue;
      }
      if (!open) runs.push_back({layer, 0, 1, false, 0, from, to});
      open = true;
      Run& run = runs.back();
      run.length_mm += length / steps;
      run.before_the_sheet = run.before_the_sheet || at_rim(sags, p);
      run.farthest_mm = std::max(run.farthest_mm, distance);
      run.to = to;
    }
  });
  return runs;
}

double length_of(const Drawing& drawing) {
  double sum = 0;
  each_segment(drawing, [&](const std::string& layer, Point2 a, Point2 b, bool) {
    if (is_feature(layer)) sum += glm::length(b - a);
  });
  return sum;
}

// ---- Sags of a mesh ----

constexpr double kSagCellMm = 2;
constexpr double kDegree = 3.14159265358979323846 / 180;
/// Sags on the page are taken for no larger, mm.
constexpr double kLargestSagMm = 5;
/// A neighbour narrower by more than this factor decides alone.
constexpr double kWidthRatio = 4;

double width_across(const Scene& scene, std::uint32_t face, const Point3& from, const Point3& along) {
  double widest = 0;
  for (const std::uint32_t v : scene.faces.contour(face, 0))
    widest = std::max(widest, glm::length(glm::cross(along, scene.vertices[v] - from)));
  return widest;
}

double cross(Point2 a, Point2 b) { return a.x * b.y - a.y * b.x; }

double distance(Point2 p, Point2 a, Point2 b, Point2 c) {
  const double u = cross(b - a, p - a), v = cross(c - b, p - b), w = cross(a - c, p - c);
  if ((u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0)) return 0;
  return std::min({distance_to_segment(p, a, b), distance_to_segment(p, b, c), distance_to_segment(p, c, a)});
}

/// Adds the arcs about an axis through the origin of which edges are chords.
void add_arcs(const Scene& scene, const Point3& axis, const View& view, PageLines& lines) {
  constexpr double kSame = 1e-4;
  constexpr int kPieces = 16;
  for (const Edge& edge : build_topology(scene).edges) {
    const Point3 &p = scene.vertices[edge.v0], &q = scene.vertices[edge.v1];
    const double along = glm::dot(p, axis);
    const Point3 foot = along * axis, a = p - foot, b = q - foot;
    const double turn = std::acos(std::clamp(glm::dot(a, b) / (glm::length(a) * glm::length(b)), -1.0, 1.0));
    if (std::abs(glm::dot(q, axis) - along) > kSame || std::abs(glm::length(a) - glm::length(b)) > kSame) continue;
    if (!(turn > kSame) || turn > kMostBendDegrees * kDegree) continue;
    const auto at = [&](int k) {
      const double t = turn * k / kPieces;
      return page_point(view, foot + (std::sin(turn - t) * a + std::sin(t) * b) / std::sin(turn));
    };
    for (int k = 0; k < kPieces; ++k) lines.add(at(k), at(k + 1));
  }
}

}  // namespace

ClearDifferences compare_clear(const std::filesystem::path& file, std::string_view view, const std::optional<Point3>& axis) {
  const LoadedModels stored = load(file, Quality::exact), repaired = load(file, Quality::clear);
  const Drawn edges = draw(stored.scene, view, Quality::exact, true),
              exact = draw(repaired.scene, view, Quality::exact, false),
              clear = draw(repaired.scene, view, Quality::clear, false);
  const Rect sheet{{0, 0}, {297, 297}};
  PageLines features(sheet, kCellMm), all(sheet, kCellMm), drawn(sheet, kCellMm);
  each_segment(edges.drawing, [&](const std::string& layer, Point2 a, Point2 b, bool) {
    all.add(a, b);
    if (is_feature(layer)) features.add(a, b);
  });
  if (axis) add_arcs(stored.scene, *axis, clear.view, all);
  each_segment(clear.drawing, [&](const std::string&, Point2 a, Point2 b, bool) { drawn.add(a, b); });
  const MeshSags sags(repaired.scene, build_topology(repaired.scene), clear.view, kMostBendDegrees);
  const auto bound = [&](Point2 p) { return sags.at(p, kPenMm / 2).value_or(0) + kPenMm / 2 + kRoundingMm; };

  ClearDifferences found;
  found.clear_mm = length_of(clear.drawing);
  found.exact_mm = length_of(exact.drawing);
  found.added = runs_beyond(
      clear.drawing, sags,
      [&](const std::string& layer, Point2 p) { return (layer == "outline" ? features : all).distance(p, kFarthestMm); },
      bound);
  found.outside = runs_beyond(
      clear.drawing, sags,
      [&](const std::string&, Point2 p) { return sags.at(p, kPenMm / 2 + kRoundingMm) ? 0 : all.distance(p, kFarthestMm); },
      bound);
  found.left_out = runs_beyond(
      exact.drawing, sags,
      [&](const std::string& layer, Point2 p) {
        return is_feature(layer) && layer != "crease" ? drawn.distance(p, kFarthestMm) : 0;
      },
      bound);
  return found;
}

std::string text_of(const std::vector<Run>& runs) {
  std::ostringstream out;
  for (const Run& run : runs)
    out << "  " << run.layer << " " << run.length_mm << " mm long, " << run.farthest_mm << " mm off, on " << run.segments
        << " segments, " << (run.before_the_sheet ? "before the sheet, " : "") << "from " << run.from.x << "," << run.from.y
        << " to " << run.to.x << "," << run.to.y << "\n";
  return out.str();
}

MeshSags::MeshSags(const Scene& scene, const Topology& topology, const View& view, double most_degrees) {
  std::vector<double> sags(scene.faces.size(), 0.0);
  for (const Edge& edge : topology.edges) {
    if (edge.face1 == kNone) continue;
    const Point3 n0 = face_normal(scene, edge.face0), n1 = face_normal(scene, edge.face1);
    const double turn = std::atan2(glm::length(glm::cross(n0, n1)), glm::dot(n0, n1));
    if (turn > most_degrees * kDegree) continue;
    const Point3 from = scene.vertices[edge.v0], to = scene.vertices[edge.v1];
    if (from == to) continue;
    const Point3 along = glm::normalize(to - from);
    const double w0 = width_across(scene, edge.face0, from, along), w1 = width_across(scene, edge.face1, from, along);
    const double rise = std::tan(turn / 4) / 2;
    sags[edge.face0] += (w0 > kWidthRatio * w1 ? w1 : w0) * rise;
    sags[edge.face1] += (w1 > kWidthRatio * w0 ? w0 : w1) * rise;
  }
  Rect bounds;
  for (const Triangle& t : topology.triangles) {
    const auto at = [&](int k) { return page_point(view, scene.vertices[t.v[static_cast<std::size_t>(k)]]); };
    const PageTriangle on_page{at(0), at(1), at(2), std::min(sags[t.face] * view.scale, kLargestSagMm)};
    if (!std::isfinite(on_page.a.x + on_page.b.x + on_page.c.x + on_page.sag)) continue;
    triangles_.push_back(on_page);
    largest_sag_ = std::max(largest_sag_, on_page.sag);
    for (const Point2 p : {on_page.a, on_page.b, on_page.c}) bounds.extend(p);
  }
  cells_.emplace(triangles_.empty() ? Rect{{0, 0}, {1, 1}} : bounds, kSagCellMm);
  for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
    const PageTriangle& t = triangles_[i];
    cells_->add(glm::min(glm::min(t.a, t.b), t.c), glm::max(glm::max(t.a, t.b), t.c), i);
  }
}

std::optional<double> MeshSags::at(Point2 p, double within_mm) const {
  const double reach = within_mm + largest_sag_;
  std::optional<double> largest;
  cells_->each(p - Point2(reach), p + Point2(reach), [&](std::uint32_t i) {
    const PageTriangle& t = triangles_[i];
    if (largest && t.sag <= *largest) return;
    if (distance(p, t.a, t.b, t.c) <= within_mm + t.sag) largest = t.sag;
  });
  return largest;
}

}  // namespace ligne::test
