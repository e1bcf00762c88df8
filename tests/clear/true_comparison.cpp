#include "clear/true_comparison.hpp"

#include "drawing/measures.hpp"

namespace ligne::test {
namespace {

constexpr double kComparedPenMm = 0.35, kSampleMm = 0.2;
/// How far a line may be drawn from its true place, beside the sag of the mesh there.
constexpr double kOffMm = 0.1;
/// A true point is surely seen when all points so far round it are, and may be seen when one of them is.
constexpr double kBesideMm = 0.06;
/// Faces that hide a point lie nearer to the viewer, by more than the faces through it do beside it: planes at edges, so
/// many times as steep, and round ones at outlines, which rise by so many roots of twice the radius and kBesideMm.
constexpr double kEdgeRises = 1.5, kOutlineRises = 1.4;
/// Least and largest distance at which a face hides an edge, and what steep faces add to it by the errors of the fine mesh.
constexpr double kLeastHidingMm = 0.1, kMostHidingMm = 0.6, kFineErrorMm = 0.05;

Viewer viewer_of(const Camera& camera) {
  if (camera.perspective) return {camera.eye, true};
  return {glm::normalize(to_eye(camera, {0, 0, 0})), false};
}

/// Adds a piece to the last one if that ends where it begins and is of its kind.
void add_piece(std::vector<OddPiece>& pieces, Point2 from, Point2 to, const TruePoint& sample) {
  constexpr double kJoinMm = kSampleMm / 4;
  const bool goes_on = !pieces.empty() && pieces.back().sample.kind == sample.kind &&
                       glm::distance(pieces.back().path.back(), from) <= kJoinMm;
  if (!goes_on) pieces.push_back({{from}, sample});
  pieces.back().path.push_back(to);
}

struct PagePoint {
  Point2 at{0, 0}, along{0, 0};
  int seen = 0;  ///< of the five points at and beside it
};

/// How far faces through an edge may lie before it, at a place beside it, in page mm.
double least_hiding(const TruePoint& point, Point2 beside, const Hiding& hiding) {
  const Point3 at = hiding.on_page(point.at), a = hiding.on_page(point.at + point.along) - at;
  double most = 0;
  for (const Point3& normal : point.normals) {
    const Point3 b = hiding.on_page(point.at + glm::cross(normal, point.along)) - at;
    const Point2 rise = Point2(a.y * b.z - b.y * a.z, b.x * a.z - a.x * b.z) / (a.x * b.y - a.y * b.x);
    const double nearer = kEdgeRises * glm::dot(rise, beside) + kFineErrorMm * glm::length(rise);
    if (!(nearer < kMostHidingMm)) return kMostHidingMm;  // seen edge on
    most = std::max(most, nearer);
  }
  return std::min(kLeastHidingMm + most, kMostHidingMm);
}

PagePoint place(const TruePoint& point, const Hiding& hiding, double scale) {
  const Point3 p = hiding.on_page(point.at);
  PagePoint placed{Point2(p), Point2(hiding.on_page(point.at + point.along)) - Point2(p)};
  const double rise = kOutlineRises * std::sqrt(2 * kBesideMm * point.radius * scale);
  for (const Point2 side : {Point2(0, 0), Point2(1, 0), Point2(0, 1), Point2(-1, 0), Point2(0, -1)}) {
    const Point2 beside = kBesideMm * side;
    const double hiding_mm = point.kind == TrueLine::outline ? rise : least_hiding(point, beside, hiding);
    placed.seen += !hiding.hides(placed.at + beside, p.z - hiding_mm);
  }
  return placed;
}

}  // namespace

Comparison compare_with_truth(const TrueScene& scene, const ViewRequest& view) {
  PictureRequest request;
  request.view = view;
  request.page.pen_width_mm = kComparedPenMm;
  request.lines.tangent = TangentLines::borders;
  RunReport run;
  const DrawnScene drawn = draw_lines(scene.drawn, request, run);
  Comparison result;
  result.drawing = drawn.compose(run);
  const View& on_page = drawn.prepared().view();
  const Hiding hiding(scene.fine, on_page);
  const Rect sheet{{0, 0}, {297, 297}};
  PageLines ink(sheet, kHidingCellMm), may_be_seen(sheet, kHidingCellMm);
  for (const Layer& layer : result.drawing.layers) for_segments(layer.lines, [&](Point2 a, Point2 b) { ink.add(a, b); });
  double largest_off = 0;
  const KnownLines known = scene.lines(viewer_of(on_page.camera), kSampleMm / on_page.scale);
  const auto add_seen = [&](const PagePoint& p) {
    if (p.seen > 0) may_be_seen.add(p.at - 0.5 * p.along, p.at + 0.5 * p.along);
  };
  for (const TruePoint& point : known.wanted) {
    const PagePoint p = place(point, hiding, on_page.scale);
    if (point.is_cusp) result.cusps.push_back(p.at);
    const double off = kOffMm + scene.sag(point) * on_page.scale;
    largest_off = std::max(largest_off, off);
    add_seen(p);
    if (p.seen < 5) continue;
    const auto kind = static_cast<std::size_t>(point.kind);
    result.kinds[kind].seen_mm += glm::length(p.along);
    if (ink.distance(p.at, off) < off) {
      result.kinds[kind].drawn_mm += glm::length(p.along);
    } else {
      add_piece(result.missing, p.at - 0.5 * p.along, p.at + 0.5 * p.along, point);
    }
  }
  for (const TruePoint& point : known.other) add_seen(place(point, hiding, on_page.scale));
  for (const Layer& layer : result.drawing.layers) {
    for_segments(layer.lines, [&](Point2 a, Point2 b) {
      const double length = glm::distance(a, b);
      const int steps = std::max(1, static_cast<int>(std::ceil(length / kSampleMm)));
      result.ink_mm += length;
      for (int m = 0; m < steps; ++m) {
        const Point2 from = a + (b - a) * (double(m) / steps), to = a + (b - a) * ((m + 1.0) / steps);
        if (may_be_seen.distance((from + to) * 0.5, largest_off) < largest_off) {
          result.true_mm += length / steps;
        } else {
          add_piece(result.extra, from, to, {});
        }
      }
    });
  }
  return result;
}

}  // namespace ligne::test
