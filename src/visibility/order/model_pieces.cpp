#include "visibility/order/model_pieces.hpp"

#include <algorithm>
#include <array>
#include <cassert>

#include "files/bytes.hpp"

namespace ligne {
namespace {

constexpr std::size_t kMany = 96;     ///< largest set for which the fewest cuts are sought; larger sets are halved. Tuned
constexpr std::size_t kSample = 512;  ///< most pieces of a set on which a candidate is judged. Tuned

struct Division {
  std::size_t front = 0, back = 0, cut = 0;

  /// The cost of a division; smaller is better. Few pieces: first the number of cuts, then the larger side. Many pieces: the
  /// larger side plus twice the cuts, which keeps the size of the tree O(n log n).
  std::array<std::size_t, 2> cost(bool many) const {
    const std::size_t larger = std::max(front, back) + cut;
    return many ? std::array{larger + cut, cut} : std::array{cut, larger};
  }
};

Division divide(const ModelPieces& pieces, std::span<const std::uint32_t> set, std::size_t stride, const ModelPlane& plane) {
  Division result;
  for (std::size_t i = 0; i < set.size(); i += stride) {
    const PlaneSide side = pieces.side(set[i], plane);
    result.front += side == PlaneSide::front;
    result.back += side == PlaneSide::back;
    result.cut += side == PlaneSide::both;
  }
  return result;
}

/// The plane across axis `k` through the median of the pieces' first corners: faces often end where corners are.
ModelPlane median_plane(const ModelPieces& pieces, std::span<const std::uint32_t> set, std::size_t stride, int k) {
  std::vector<double> places;
  for (std::size_t i = 0; i < set.size(); i += stride) places.push_back(pieces.point(pieces.corners(set[i])[0])[k]);
  const auto middle = places.begin() + static_cast<std::ptrdiff_t>(places.size() / 2);
  std::nth_element(places.begin(), middle, places.end());
  ModelPlane plane{Point3(0), Point3(0)};
  plane.normal[k] = 1;
  plane.point[k] = *middle;
  return plane;
}

/// Rounding error of a height, relative to the largest coordinate: three differences, their products with a rounded unit
/// vector, and two sums; likewise for the corner of a cut, and for a cut of a cut.
constexpr double kModelHeightRounding = 0x1p-48;

/// a b - c d with a relative error of two roundings despite cancellation (Kahan's difference of products).
double difference_of_products(double a, double b, double c, double d) {
  const double cd = c * d;
  const double error = std::fma(-c, d, cd);
  return std::fma(a, b, -cd) + error;
}

double largest_part(const Point3& p) { return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}); }

}  // namespace

ModelPlane plane_through(const Point3& a, const Point3& b, const Point3& c) {
  Point3 u = b - a, v = c - a;
  // Both vectors are scaled to about unit length: products of tiny triangles would underflow.
  const double size_u = largest_part(u), size_v = largest_part(v);
  if (size_u == 0 || size_v == 0) return {Point3(0), a};
  u /= size_u;
  v /= size_v;
  const Point3 n{difference_of_products(u.y, v.z, u.z, v.y), difference_of_products(u.z, v.x, u.x, v.z),
                 difference_of_products(u.x, v.y, u.y, v.x)};
  const double size = largest_part(n);
  if (size == 0) return {Point3(0), a};
  return {glm::normalize(n / size), a};
}

ModelPieces::ModelPieces(const Scene& scene)
    : triangles_(triangulate_faces(scene)), points_(scene.vertices), vertices_(points_.size()) {
  find_planes();
  pieces_.reserve(triangles_.size());
  corners_.reserve(3 * triangles_.size());
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
    if (normals_[t] == Point3(0)) continue;
    const auto begin = static_cast<std::uint32_t>(corners_.size());
    corners_.insert(corners_.end(), triangles_[t].v.begin(), triangles_[t].v.end());
    pieces_.push_back({begin, begin + 3, t});
  }
}

/// Finds the planes of the triangles, and the tolerance of heights over them.
void ModelPieces::find_planes() {
  double largest = 0;
  for (const Point3& p : points_) largest = std::max(largest, largest_part(p));
  tolerance_ = kModelHeightRounding * largest;
  normals_.reserve(triangles_.size());
  for (const Triangle& t : triangles_)
    normals_.push_back(plane_through(points_[t.v[0]], points_[t.v[1]], points_[t.v[2]]).normal);
}

ModelPieces::ModelPieces(ByteReader& bytes, const Scene& scene)
    : triangles_(bytes.list<Triangle>()), points_(scene.vertices), vertices_(points_.size()) {
  for (const Triangle& t : triangles_) {
    bytes.need(t.face < scene.faces.size(), "a triangle is of no face");
    for (const std::uint32_t v : t.v) bytes.need(v < points_.size(), "a triangle has a vertex that is not there");
  }
  find_planes();
  // Corners of cuts lie between vertices, so the tolerance from the vertices holds for them.
  for (const Point3& p : bytes.list<Point3>()) {
    bytes.need(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z), "the corner of a cut is not a point");
    points_.push_back(p);
  }
  corners_ = bytes.list<std::uint32_t>();
  for (const std::uint32_t corner : corners_) bytes.need(corner < points_.size(), "a piece has a corner that is not there");
  pieces_ = bytes.list<ModelPiece>();
  for (const ModelPiece& piece : pieces_) {
    bytes.need(piece.begin < piece.end && piece.end <= corners_.size() && piece.end - piece.begin >= 3,
               "a piece has fewer than three corners");
    bytes.need(piece.triangle < triangles_.size() && normals_[piece.triangle] != Point3(0), "a piece has no plane");
  }
}

void ModelPieces::write(ByteWriter& bytes) const {
  bytes.list(std::span<const Triangle>(triangles_));
  bytes.list(std::span<const Point3>(points_).subspan(vertices_));
  bytes.list(std::span<const std::uint32_t>(corners_));
  bytes.list(std::span<const ModelPiece>(pieces_));
}

PlaneSide ModelPieces::side(std::uint32_t piece, const ModelPlane& plane) const {
  double low = 0, high = 0;
  for (const std::uint32_t corner : corners(piece)) {
    const double h = plane.height(points_[corner]);
    low = std::min(low, h);
    high = std::max(high, h);
  }
  return side_of_heights(low, high);
}

std::uint32_t ModelPieces::crossing(std::uint32_t a, std::uint32_t b, const ModelPlane& plane) {
  if (b < a) std::swap(a, b);
  const Point3 p = points_[a], q = points_[b];
  const double h = plane.height(p), k = plane.height(q);
  points_.push_back(p + (q - p) * (h / (h - k)));
  return static_cast<std::uint32_t>(points_.size() - 1);
}

std::uint32_t ModelPieces::cut(std::uint32_t piece, const ModelPlane& plane) {
  assert(side(piece, plane) == PlaneSide::both);
  front_.clear();
  back_.clear();
  const auto count = corners(piece).size();
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t corner = corners(piece)[i], next = corners(piece)[i + 1 == count ? 0 : i + 1];
    const double h = plane.height(points_[corner]), k = plane.height(points_[next]);
    if (h >= -tolerance_) front_.push_back(corner);
    if (h <= tolerance_) back_.push_back(corner);
    if ((h > tolerance_ && k < -tolerance_) || (h < -tolerance_ && k > tolerance_)) {
      const std::uint32_t middle = crossing(corner, next, plane);
      front_.push_back(middle);
      back_.push_back(middle);
    }
  }
  const auto append = [&](const std::vector<std::uint32_t>& list) {
    const auto begin = static_cast<std::uint32_t>(corners_.size());
    corners_.insert(corners_.end(), list.begin(), list.end());
    return ModelPiece{begin, static_cast<std::uint32_t>(corners_.size()), pieces_[piece].triangle};
  };
  pieces_[piece] = append(front_);
  pieces_.push_back(append(back_));
  const auto behind = static_cast<std::uint32_t>(pieces_.size() - 1);
  assert(side(piece, plane) == PlaneSide::front && side(behind, plane) == PlaneSide::back);
  return behind;
}

ModelPieces ModelPieces::extract(std::span<const std::uint32_t> pieces) const {
  ModelPieces result;
  std::vector<std::uint32_t>& origins = result.origins_;
  origins.reserve(3 * pieces.size());
  for (const std::uint32_t piece : pieces) {
    const auto& v = triangles_[pieces_[piece].triangle].v;
    origins.insert(origins.end(), corners(piece).begin(), corners(piece).end());
    if (!std::equal(v.begin(), v.end(), corners(piece).begin(), corners(piece).end())) {
      origins.insert(origins.end(), v.begin(), v.end());
    }
  }
  std::sort(origins.begin(), origins.end());
  origins.erase(std::unique(origins.begin(), origins.end()), origins.end());
  const auto number = [&](std::uint32_t corner) {
    return static_cast<std::uint32_t>(std::lower_bound(origins.begin(), origins.end(), corner) - origins.begin());
  };
  for (const std::uint32_t corner : origins) result.points_.push_back(points_[corner]);
  result.vertices_ = result.points_.size();
  result.tolerance_ = tolerance_;
  for (const std::uint32_t piece : pieces) {
    const std::uint32_t t = pieces_[piece].triangle;
    Triangle triangle = triangles_[t];
    for (std::uint32_t& v : triangle.v) v = number(v);
    const auto begin = static_cast<std::uint32_t>(result.corners_.size());
    for (const std::uint32_t corner : corners(piece)) result.corners_.push_back(number(corner));
    // One triangle per piece: the piece and its triangle have the same number.
    result.pieces_.push_back(
        {begin, static_cast<std::uint32_t>(result.corners_.size()), static_cast<std::uint32_t>(result.triangles_.size())});
    result.triangles_.push_back(triangle);
    result.normals_.push_back(normals_[t]);
  }
  result.uncut_corners_ = result.corners_.size();
  return result;
}

std::vector<std::uint32_t> ModelPieces::take_over(const ModelPieces& extracted, std::span<const std::uint32_t> pieces) {
  std::vector<std::uint32_t> numbers(pieces.begin(), pieces.end());
  const auto first_point = static_cast<std::uint32_t>(points_.size());
  const auto known = static_cast<std::uint32_t>(extracted.vertices_);
  points_.insert(points_.end(), extracted.points_.begin() + known, extracted.points_.end());
  for (std::uint32_t i = 0; i < extracted.pieces_.size(); ++i) {
    const ModelPiece& piece = extracted.pieces_[i];
    if (piece.begin < extracted.uncut_corners_) continue;
    const auto begin = static_cast<std::uint32_t>(corners_.size());
    for (const std::uint32_t corner : extracted.corners(i)) {
      corners_.push_back(corner < known ? extracted.origins_[corner] : first_point + (corner - known));
    }
    const ModelPiece cut{begin, static_cast<std::uint32_t>(corners_.size()), pieces_[pieces[piece.triangle]].triangle};
    if (i < pieces.size()) {
      pieces_[pieces[i]] = cut;
    } else {
      numbers.push_back(static_cast<std::uint32_t>(pieces_.size()));
      pieces_.push_back(cut);
    }
  }
  return numbers;
}

DividingPlane choose_plane(const ModelPieces& pieces, std::span<const std::uint32_t> set, const PlaneChoice& choice,
                           std::uint64_t seed) {
  const auto of_face = [&](std::uint32_t piece) { return DividingPlane{pieces.plane_of(piece), pieces.face(piece)}; };
  if (set.size() == 1) return of_face(set[0]);
  const bool many = choice.free_planes && set.size() > kMany;
  const std::size_t stride = (set.size() + kSample - 1) / kSample;
  DividingPlane best;
  std::array<std::size_t, 2> least{};
  bool any = false;
  const auto consider = [&](const DividingPlane& candidate) {
    const Division division = divide(pieces, set, stride, candidate.plane);
    // A plane that belongs to no face must leave pieces on both sides.
    const bool divides = division.front + division.cut < set.size() && division.back + division.cut < set.size();
    if (candidate.face == kNone && (!divides || std::min(division.front, division.back) == 0)) return;
    const auto cost = division.cost(many);
    if (any && !(cost < least)) return;
    any = true;
    least = cost;
    best = candidate;
  };
  if (set.size() <= choice.candidates) {
    for (const std::uint32_t piece : set) consider(of_face(piece));
  } else {
    for (unsigned i = 0; i < choice.candidates; ++i) {
      seed = scramble(seed);
      consider(of_face(set[seed % set.size()]));
    }
  }
  if (many) {
    for (int k = 0; k < 3; ++k) consider({median_plane(pieces, set, stride, k), kNone});
  }
  return best;
}

}  // namespace ligne
