#include "visibility/order/paint_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace ligne {
namespace {

constexpr int kCells = 64;  ///< columns and rows of the grid for searching pieces. Tuned

bool covers(const PaintPiece& piece, Point2 p) {
  bool in = false;
  for (const auto& contour : piece.contours) {
    for (std::size_t i = 0; i < contour.size(); ++i) {
      const Point2 a = contour[i], b = contour[i + 1 == contour.size() ? 0 : i + 1];
      if ((a.y <= p.y) != (b.y <= p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) in = !in;
    }
  }
  return in;
}

/// The pieces over each cell of the page, in painting order.
class PieceGrid {
 public:
  explicit PieceGrid(const PaintOrder& order) : pieces_(order.pieces), cells_(kCells * kCells) {
    for (const PaintPiece& piece : pieces_) {
      for (const Point2& p : piece.contours[0]) page_.extend(p);
    }
    for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
      Rect box;
      for (const Point2& p : pieces_[i].contours[0]) box.extend(p);
      for (int y = row(box.min.y); y <= row(box.max.y); ++y) {
        for (int x = column(box.min.x); x <= column(box.max.x); ++x) cells_[y * kCells + x].push_back(i);
      }
    }
  }

  /// True if the piece is the last that covers the point.
  bool is_seen(std::uint32_t piece, Point2 p) const {
    const std::vector<std::uint32_t>& cell = cells_[row(p.y) * kCells + column(p.x)];
    for (auto later = cell.rbegin(); later != cell.rend() && *later >= piece; ++later) {
      if (covers(pieces_[*later], p)) return *later == piece;
    }
    return false;
  }

 private:
  static int cell(double v, double low, double high) {
    return high > low ? std::clamp(static_cast<int>((v - low) / (high - low) * kCells), 0, kCells - 1) : 0;
  }
  int column(double x) const { return cell(x, page_.min.x, page_.max.x); }
  int row(double y) const { return cell(y, page_.min.y, page_.max.y); }

  const std::vector<PaintPiece>& pieces_;
  Rect page_;
  std::vector<std::vector<std::uint32_t>> cells_;
};

/// The centre of a contour's corners, and points between it and the corners and midpoints of sides.
std::vector<Point2> points_to_try(const std::vector<Point2>& contour) {
  constexpr double kParts[] = {0.5, 0.8, 0.95};  // adjustable
  const Point2 middle = std::accumulate(contour.begin(), contour.end(), Point2{0, 0}) / double(contour.size());
  std::vector<Point2> points{middle};
  for (const double part : kParts) {
    for (std::size_t i = 0; i < contour.size(); ++i) {
      const Point2 a = contour[i], b = contour[i + 1 == contour.size() ? 0 : i + 1];
      points.push_back(middle + (a - middle) * part);
      points.push_back(middle + ((a + b) * 0.5 - middle) * part);
    }
  }
  return points;
}

/// A directed side of a piece. Cuts through a common side of two pieces give both the same corner.
struct DirectedSide {
  Point3 from, to;
  std::array<double, 6> key() const { return {from.x, from.y, from.z, to.x, to.y, to.z}; }
  std::array<double, 6> opposite() const { return {to.x, to.y, to.z, from.x, from.y, from.z}; }
};

/// The sides that no two equally oriented pieces share, joined into contours. Where several contours pass through one
/// corner, any continuation gives the same area under parity filling.
std::vector<std::vector<Point3>> outer_contours(const ModelPieces& pieces, std::span<const std::uint32_t> parts) {
  std::vector<DirectedSide> sides;
  for (const std::uint32_t part : parts) {
    const std::span<const std::uint32_t> corners = pieces.corners(part);
    for (std::size_t i = 0; i < corners.size(); ++i)
      sides.push_back({pieces.point(corners[i]), pieces.point(corners[i + 1 == corners.size() ? 0 : i + 1])});
  }
  std::ranges::sort(sides, {}, &DirectedSide::key);
  std::vector<std::uint8_t> taken(sides.size(), 0);
  const auto find = [&](const std::array<double, 6>& key) {
    return static_cast<std::size_t>(std::ranges::lower_bound(sides, key, {}, &DirectedSide::key) - sides.begin());
  };
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const std::size_t other = find(sides[i].opposite());
    taken[i] = other < sides.size() && sides[other].key() == sides[i].opposite();
  }
  std::vector<std::vector<Point3>> contours;
  for (std::size_t first = 0; first < sides.size(); ++first) {
    if (taken[first]) continue;
    std::vector<Point3>& contour = contours.emplace_back();
    for (std::size_t side = first; side < sides.size();) {
      taken[side] = 1;
      contour.push_back(sides[side].from);
      const Point3 at = sides[side].to;
      constexpr double kLeast = std::numeric_limits<double>::lowest();
      side = find({at.x, at.y, at.z, kLeast, kLeast, kLeast});
      while (side < sides.size() && sides[side].from == at && taken[side]) ++side;
      if (side < sides.size() && sides[side].from != at) break;
    }
  }
  return contours;
}

double twice_area(const std::vector<Point2>& contour) {
  double sum = 0;
  for (std::size_t i = 2; i < contour.size(); ++i) sum += cross(contour[i - 1] - contour[0], contour[i] - contour[0]);
  return std::abs(sum);
}

}  // namespace

Viewpoint viewpoint_of(const Camera& camera) { return {camera.eye, -camera.forward, camera.perspective}; }

std::vector<std::uint8_t> shown_faces(const ProjectedScene& scene) {
  std::vector<std::uint8_t> shown(scene.model->faces.size(), 0);
  for (const Triangle& t : scene.triangles) {
    if (!scene.is_edge_on(t)) shown[t.face] = 1;
  }
  return shown;
}

PagePlanes::PagePlanes(const View& view) : to_page_(glm::transpose(glm::inverse(view.model_to_page))) {}

std::array<double, 3> PagePlanes::operator()(const ModelPlane& plane) const {
  const glm::dvec4 p = to_page_ * glm::dvec4(plane.normal, -glm::dot(plane.normal, plane.point));
  return {-p.x / p.z, -p.y / p.z, -p.w / p.z};
}

PaintPieces::PaintPieces(const ProjectedScene& scene, const ModelPieces& pieces)
    : view_(scene.view),
      pieces_(pieces),
      volume_(face_volume(scene.view, scene.lattice)),
      page_planes_(scene.view),
      is_seen_(shown_faces(scene)) {}

bool PaintPieces::project(std::span<const Point3> contour) {
  corners_.clear();
  for (const Point3& p : contour) corners_.push_back(to_homogeneous(view_, p));
  clip_contour(corners_, volume_);
  return corners_.size() >= 3;
}

/// Stores the visible part of the piece in corners_; returns false if there is none.
bool PaintPieces::project(std::uint32_t piece) {
  corners_.clear();
  if (!is_seen_[pieces_.face(piece)]) return false;
  for (const std::uint32_t corner : pieces_.corners(piece)) corners_.push_back(to_homogeneous(view_, pieces_.point(corner)));
  clip_contour(corners_, volume_);
  return corners_.size() >= 3;
}

std::vector<std::vector<Point2>> PaintPieces::outlines_of_cut() {
  std::vector<std::uint32_t> count(pieces_.triangles().size(), 0);
  for (const ModelPiece& piece : pieces_.pieces()) ++count[piece.triangle];
  std::vector<std::vector<Point2>> outlines;
  for (std::uint32_t piece = 0; piece < pieces_.pieces().size(); ++piece) {
    if (count[pieces_.pieces()[piece].triangle] < 2 || !project(piece)) continue;
    std::vector<Point2>& outline = outlines.emplace_back();
    for (const HomogeneousPoint& p : corners_) outline.emplace_back(p.x / p.w, p.y / p.w);
    outline.push_back(outline.front());
  }
  return outlines;
}

void PaintPieces::add(std::uint32_t piece, PaintOrder& order) {
  if (!project(piece)) return;
  PaintPiece painted{pieces_.face(piece), {{}}, page_planes_(pieces_.plane_of(piece))};
  for (const double c : painted.plane) {
    if (!std::isfinite(c)) return;  // seen edge on
  }
  for (const HomogeneousPoint& p : corners_) painted.contours[0].emplace_back(p.x / p.w, p.y / p.w);
  order.pieces.push_back(std::move(painted));
}

void PaintPieces::add_whole(std::span<const std::uint32_t> pieces, const std::array<double, 3>& plane, PaintOrder& order) {
  if (pieces.size() == 1) return add(pieces[0], order);
  if (!is_seen_[pieces_.face(pieces[0])]) return;
  PaintPiece painted{pieces_.face(pieces[0]), {}, plane};
  for (const std::vector<Point3>& contour : outer_contours(pieces_, pieces)) {
    if (!project(contour)) continue;
    std::vector<Point2>& on_page = painted.contours.emplace_back();
    for (const HomogeneousPoint& p : corners_) on_page.emplace_back(p.x / p.w, p.y / p.w);
  }
  if (painted.contours.empty()) return;
  const auto outer = std::ranges::max_element(painted.contours, {}, twice_area);
  std::swap(*outer, painted.contours.front());
  order.pieces.push_back(std::move(painted));
}

std::vector<PageNumber> order_numbers(const PaintOrder& order, std::span<const std::uint32_t> group_of) {
  const PieceGrid grid(order);
  std::vector<PageNumber> numbers;
  std::vector<std::uint8_t> has_number(group_of.empty() ? 0 : *std::ranges::max_element(group_of) + 1, 0);
  for (std::uint32_t i = 0; i < order.pieces.size(); ++i) {
    if (has_number[group_of[i]]) continue;
    const std::vector<Point2> points = points_to_try(order.pieces[i].contours[0]);
    const auto seen = std::ranges::find_if(points, [&](Point2 p) { return grid.is_seen(i, p); });
    if (seen == points.end()) continue;
    has_number[group_of[i]] = 1;
    numbers.push_back({*seen, group_of[i]});
  }
  return numbers;
}

std::vector<PageNumber> order_numbers(const PaintOrder& order) {
  std::vector<std::uint32_t> group_of;
  std::uint32_t group = 0;
  for (std::size_t i = 0; i < order.pieces.size(); ++i) {
    if (i == 0 || order.pieces[i].face != order.pieces[i - 1].face) ++group;
    group_of.push_back(group);
  }
  return order_numbers(order, group_of);
}

}  // namespace ligne
