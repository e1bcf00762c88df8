#pragma once
/// The parts of the oracle: exact numbers, the projection, faces and edges, lines and what changes along them.

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include "oracle/oracle.hpp"

namespace oracle {

/// A rational number. CGAL computes with intervals first, and exactly where these do not decide.
using Exact = CGAL::Exact_predicates_exact_constructions_kernel::FT;

struct Vector3 {
  Exact x, y, z;
};

inline Vector3 exact(const ligne::Point3& p) { return {Exact(p.x), Exact(p.y), Exact(p.z)}; }
inline Vector3 operator+(const Vector3& a, const Vector3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vector3 operator-(const Vector3& a, const Vector3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vector3 operator*(const Exact& k, const Vector3& a) { return {k * a.x, k * a.y, k * a.z}; }
inline Exact dot(const Vector3& a, const Vector3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline bool is_zero(const Vector3& a) { return a.x == 0 && a.y == 0 && a.z == 0; }

inline double to_double(const Exact& v) { return CGAL::to_double(v); }
inline ligne::Point3 to_point(const Vector3& v) { return {to_double(v.x), to_double(v.y), to_double(v.z)}; }
inline double length(const Vector3& v) { return std::sqrt(to_double(dot(v, v))); }

/// Certain lower and upper bound.
inline double lower(const Exact& v) { return CGAL::to_interval(v).first; }
inline double upper(const Exact& v) { return CGAL::to_interval(v).second; }

// The exact projection.

/// A point of the drawing plane with its depth, in units of its own that make all three coordinates rational: parallel (X,
/// Y, F), perspective (X / F, Y / F, -1 / F), with X = right . d, Y = down . d, F = forward . d of vectors that are not
/// normalized. Depth grows with the distance. Lines and planes stay lines and planes.
struct PagePoint {
  Exact x, y, z;
};

/// The plane z = a + b x + c y.
struct PagePlane {
  Exact a, b, c;
  Exact z(const Exact& x, const Exact& y) const { return a + b * x + c * y; }
};

/// X, Y, F of a point of the model.
struct SightPoint {
  Exact x, y, f;
};

class Projection {
 public:
  explicit Projection(const View& view);

  bool perspective() const { return perspective_; }
  const Vector3& eye() const { return eye_; }
  const Vector3& forward() const { return forward_; }

  SightPoint sight_point(const Vector3& p) const;
  /// In perspective: nearer than the near plane, so that it can not be drawn.
  bool too_near(const SightPoint& p) const { return perspective_ && p.f < near_; }
  const Exact& near() const { return near_; }
  /// Requires a point that is not too near.
  PagePoint page_point(const SightPoint& p) const;

  /// The plane through `on_plane` with the normal; `edge_on` when the page sees a line of it, and then nothing is returned:
  /// in perspective when the eye is not farther from it than `eye_error`, in model units.
  PagePlane page_plane(const Vector3& normal, const Vector3& on_plane, double eye_error, bool& edge_on) const;

  /// The model point that is drawn at the page point.
  Vector3 model_point(const PagePoint& p) const;

  // Millimetres of the page for one unit of x, y and depth; and the page's own coordinates.
  double mm_x() const { return mm_x_; }
  double mm_y() const { return mm_y_; }
  double mm_z() const { return mm_z_; }
  Point2 page_mm(const PagePoint& p) const {
    return {offset_.x + mm_x_ * to_double(p.x), offset_.y + mm_y_ * to_double(p.y)};
  }
  double depth_mm(const Exact& z) const { return depth_0_ + mm_z_ * to_double(z); }
  double x_of(double page_x_mm) const { return (page_x_mm - offset_.x) / mm_x_; }
  double y_of(double page_y_mm) const { return (page_y_mm - offset_.y) / mm_y_; }
  /// Page mm per model unit at the point, over that at the target: 1 in parallel projection.
  double magnification(const PagePoint& p) const;

 private:
  bool perspective_;
  Vector3 eye_, right_, down_, forward_;
  Exact near_;
  Exact right2_, down2_, forward2_;  ///< squares of the lengths
  double mm_x_, mm_y_, mm_z_, depth_0_;
  Point2 offset_;
};

// The scene's faces and edges as the oracle sees them.

/// Certain bounds on the page, in the units of PagePoint.
struct Box {
  double x0 = 1e300, y0 = 1e300, x1 = -1e300, y1 = -1e300, z0 = 1e300, z1 = -1e300;

  void add(const PagePoint& p);
  bool meets(const Box& other, double margin_x, double margin_y) const {
    return x0 - margin_x <= other.x1 && other.x0 <= x1 + margin_x && y0 - margin_y <= other.y1 && other.y0 <= y1 + margin_y;
  }
};

struct Face {
  Vector3 normal, centre;  ///< its plane: Newell's normal of the outer contour, through the mean of its corners
  bool flat = false;       ///< without area: it has no plane
  int facing = 0;          ///< +1 looks at the viewer, -1 away, 0 is seen edge on
  bool facing_sure = true;

  // On the page, cut off before the near plane. Contours one after the other; points inside have an odd number of sides
  // to their left.
  bool hides = false;  ///< has area on the page
  bool clear = false;  ///< transparent, and nothing counts as hidden by it
  std::vector<PagePoint> corners;
  std::vector<std::array<std::uint32_t, 2>> sides;  ///< corners from and to
  std::vector<Point2> corners_mm;                   ///< the corners on the page, rounded
  PagePlane plane;
  Box box;
  double gradient = 0;  ///< mm of depth by mm of the page
  double slack_mm = 0;  ///< how far in depth the corners are off the plane
};

/// Faces whose plane is nearer to the eye than `input_error`, in model units, are seen edge on.
std::vector<Face> make_faces(const ligne::Scene& scene, const Projection& projection, double input_error);

/// Edges by object and position, classes included.
std::vector<Edge> make_edges(const ligne::Scene& scene, const std::vector<Face>& faces, double crease_degrees);

// A line on the page and what covers it.

/// Half the width of a line's cross-section: the micrometre that a drawing owes.
inline constexpr double kMicrometre = 0.001;

/// A segment of the page with coordinates of its own: tau runs along it from 0 to 1, s across it, in micrometres of the page
/// (to a rounding; the axes themselves are exact).
class Line {
 public:
  Line(const PagePoint& a, const PagePoint& b, const Projection& projection);

  PagePoint a, b;
  Exact dx, dy;  ///< b - a
  Exact ox, oy;  ///< one micrometre across

  Point2 a_mm{0, 0}, direction_mm{0, 0};  ///< rounded; the direction has length 1
  double length_mm = 0;
  Box box;

  /// Surely the face lies beside the line, farther than its cross-section reaches: told in doubles with ample room for
  /// roundings, so that nothing exact need be computed.
  bool surely_beside(const Face& face) const;

  Exact tau(const PagePoint& p) const { return ((p.x - a.x) * oy - (p.y - a.y) * ox) / det_; }
  Exact s(const PagePoint& p) const { return (dx * (p.y - a.y) - dy * (p.x - a.x)) / det_; }

 private:
  Exact det_;
};

/// A face in the coordinates of a line.
struct FaceOverLine {
  struct Corner {
    Exact tau, s;
    double tau_rounded = 0, s_rounded = 0;
  };
  const Face* face = nullptr;
  std::vector<Corner> corners;
  // The line's depth behind the face's plane is behind_a + tau (behind_b - behind_a). Below -delta the face is behind the
  // line.
  Exact behind_a, behind_b;
  double delta = 0;

  FaceOverLine(const Face& face, const Line& line);
  /// Finds the corners' places, without which the line can only be asked whether it is before the plane.
  void find_corners(const Line& line);
  Exact behind(const Exact& tau) const { return behind_a + tau * (behind_b - behind_a); }

  /// The parts of the cross-section at tau that the face covers, in order: parts [first, second] of the s axis.
  std::vector<std::pair<Exact, Exact>> cover(double tau) const;
};

/// Places on the line at which something changes: where sides of the face cross the line or come within `reach` micrometres
/// of it, where corners lie that near, and where the line comes to the depths -delta, 0 and delta behind the face. Rounded:
/// a place only says where to cut, what the parts between are told is found out exactly.
void add_changes(const FaceOverLine& face, double reach, std::vector<double>& places);

/// Places where sides of different faces cross each other within `reach` of the line, for sides that stay there for longer
/// than `longest` (a part of the line); shorter ones change nothing that is longer.
void add_crossings(const std::vector<FaceOverLine>& faces, double reach, double longest, std::vector<double>& places);

/// Sorts the places and returns the parts between them that are longer than `shortest`, in order.
std::vector<std::array<double, 2>> parts_between(std::vector<double> places, double shortest);

// The data of the oracle, and the way it judges a line.

/// A part of a line, from tau0 to tau1.
struct Part {
  double tau0 = 0, tau1 = 1;
  Answer answer = Answer::undecided;
  bool exactly_hidden = false;
};

/// An intersection with its line, exact.
struct CrossingLine {
  PagePoint a, b;
  std::vector<std::uint32_t> own_faces;  ///< which do not hide it
};

/// The part from t0 to t1 of a segment of the model.
struct LineInView {
  double t0, t1;
  Line line;
};

struct Oracle::State {
  State(const ligne::Scene& scene, const View& view, double crease_degrees, Glass glass);

  View view;
  Projection projection;
  std::vector<Face> faces;
  std::vector<Edge> edges;
  std::vector<Intersection> intersections;
  std::vector<CrossingLine> crossings;  ///< parallel to intersections
  double touch_distance;                ///< 2^-44 of the scene's size, model units
  double input_error_mm;                ///< error of the input's coordinates on the page, at the target

  /// The largest depth, in units of PagePoint, by which face and line may be off for all that is known.
  double delta(const Face& face, const Line& line) const;
  bool lies_in_plane(const Vector3& p, const Face& face) const;

  /// The part of the segment inside the window and before the near plane, as parameters in model space.
  std::optional<std::array<double, 2>> part_in_view(const Vector3& a, const Vector3& b) const;
  /// An edge as a line; nothing when it is seen end on.
  std::optional<LineInView> line_in_view(const Vector3& a, const Vector3& b) const;

  /// The visibility of the line from model point a to b; `own_faces` do not hide it. Parts follow each other from 0 to 1.
  std::vector<Part> judge(const Line& line, const Vector3& a, const Vector3& b,
                          std::span<const std::uint32_t> own_faces) const;

  void find_intersections();  ///< intersections.cpp
};

}  // namespace oracle
