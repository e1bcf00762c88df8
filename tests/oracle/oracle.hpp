#pragma once
/// The oracle: an exact hidden-line program, slow and plain, against which the methods are held. It knows the scene
/// structure of src/scene and nothing else of src/.
///
/// Every number that decides anything is an exact rational. The view is taken from the same doubles as the library's view,
/// so that no rounding of a camera comes between them.
///
/// The rule. A point P of an edge E is hidden when both of its banks, the page just left and just right of E, are covered by
/// faces in front of P, whatever faces. Faces without area on the page hide nothing, among them those in whose plane the eye
/// lies to the error of the input; neither does a face of which E is a
/// side, nor one in whose plane E lies (both ends within 2^-44 of the scene's size).
///
/// The three answers. A drawing owes a micrometre, so what turns over within a micrometre is `undecided`:
///   hidden   faces that are in front of P by more than delta cover the whole cross-section through P, that is the page from
///            one micrometre to the left to one micrometre to the right;
///   visible  no face that is in front of P, or less than delta behind it, covers anything of the cross-section.
/// Within a micrometre of places where sides cross the edge nothing is asked: that is undecided too. Within a micrometre of
/// the window's border a line may be in view or not: what is not hidden there is undecided. delta = 1 um (1 + g) + 2 e m (m
/// + g) + s, g the gradient of the face's depth, e the error of the input on the page, m the magnification at P, s how far
/// the face's own corners are off its plane.

#include "scene/model/scene.hpp"
#include "support/standard.hpp"

namespace oracle {

using ligne::Point2;
using ligne::Point3;

/// A camera and its place on the page. Page mm, x right, y down. With d = p - eye and unit vectors right, down, forward made
/// of the line of sight and up, the point p is drawn, in parallel projection, at offset + scale (right . d, down . d), and
/// in perspective at offset + scale D (right . d, down . d) / (forward . d), D the distance of the target.
struct View {
  bool perspective = false;
  Point3 direction{0, 1, 0};               ///< parallel: line of sight, any length
  Point3 eye{0, 0, 0};                     ///< parallel: any point
  Point3 target{0, 1, 0};                  ///< perspective
  Point3 up{0, 0, 1};                      ///< not parallel to the line of sight
  double scale = 1;                        ///< page mm per model unit (in perspective: on the target's plane)
  Point2 offset{0, 0};                     ///< where the line of sight through the eye meets the page
  ligne::Rect window{{0, 0}, {297, 210}};  ///< edges are cut a micrometre outside its sides, faces are not
};

enum class Answer : std::uint8_t { visible, hidden, undecided };

/// In the order of ligne::LineClass.
enum class EdgeClass : std::uint8_t { outline, border, intersection, crease, mesh, undecided };

/// A part of a line, as long as nothing changes.
struct Interval {
  double t0 = 0, t1 = 1;        ///< parameters on the edge in model space, t0 < t1
  Point2 from{0, 0}, to{0, 0};  ///< the same on the page, mm
  Answer answer = Answer::undecided;
  bool exactly_hidden = false;  ///< by the exact rule, without tolerances
  bool at_border = false;       ///< within a micrometre of the window's border, or beyond it
  friend bool operator==(const Interval&, const Interval&) = default;
};

/// An edge of the scene.
struct Edge {
  std::uint32_t object = 0;
  Point3 a{0, 0, 0}, b{0, 0, 0};     ///< parameter 0 and 1; a is lexicographically smaller
  std::vector<std::uint32_t> faces;  ///< faces of the scene, ascending; a face that runs along it twice stands here twice
  EdgeClass edge_class = EdgeClass::undecided;
  friend bool operator==(const Edge&, const Edge&) = default;
};

/// The common segment of two penetrating faces, or a part of it: near its ends a crossing is not proper.
struct Intersection {
  std::uint32_t face0 = 0, face1 = 0;  ///< face0 < face1
  Point3 a{0, 0, 0}, b{0, 0, 0};       ///< rounded
  Point2 page_a{0, 0}, page_b{0, 0};   ///< the same on the page, mm
  /// A proper crossing, to be drawn where it is visible: both faces go on on both sides of it by a micrometre, and so far
  /// that their depths differ by more than delta. Otherwise a method may take the faces for touching ones.
  bool proper = false;
  /// The faces are so nearly parallel that the place of their common line hangs on the last digits.
  bool vague = false;
  friend bool operator==(const Intersection&, const Intersection&) = default;
};

/// A face over a point of the page.
struct FaceHit {
  std::uint32_t face = 0;
  double depth_mm = 0;   ///< grows with the distance from the viewer, as in ligne::View
  bool on_side = false;  ///< the point lies exactly on a side of the face
};

/// Whether transparent faces hide as others do, or nothing.
enum class Glass : std::uint8_t { hides, is_clear };

class Oracle {
 public:
  /// Edges whose faces' normals differ by more than `crease_degrees` are creases.
  Oracle(const ligne::Scene& scene, const View& view, double crease_degrees = 30, Glass glass = Glass::hides);
  ~Oracle();
  Oracle(const Oracle&) = delete;
  Oracle& operator=(const Oracle&) = delete;

  /// All edges, ordered by object and position, whether in view or not.
  std::span<const Edge> edges() const;
  std::span<const Intersection> intersections() const;

  /// The visible parts of the edge: those inside the window, or a micrometre beside it, and before the near plane (a
  /// thousandth of the target's distance), in order. Empty when nothing of it is in view or it is seen end on.
  std::vector<Interval> visible_intervals(std::size_t edge) const;
  /// The visible parts of an intersection.
  std::vector<Interval> intersection_intervals(std::size_t intersection) const;

  /// The faces over the point of the page, nearest first; ties in the order of the faces.
  std::vector<FaceHit> faces_at(Point2 page_mm) const;
  /// Distance in mm on the page from the point to the nearest side of any face, to tell points at which nothing is decided.
  double distance_to_sides(Point2 page_mm) const;

  struct State;  ///< state.hpp; of no use outside this folder

 private:
  std::unique_ptr<State> state_;
};

}  // namespace oracle
