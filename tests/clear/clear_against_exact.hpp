#pragma once
/// A clear drawing against the exact one of the same model.

#include "linework/stroke.hpp"
#include "scene/model/topology.hpp"
#include "support/page_lines.hpp"
#include "view/view.hpp"

namespace ligne::test {

/// A maximal run of points of one line for which something does not hold.
struct Run {
  std::string layer;
  double length_mm = 0;
  int segments = 0;               ///< of the line, that the run touches
  bool before_the_sheet = false;  ///< a point of it lies at the body's own outline
  double farthest_mm = 0;         ///< the largest distance from the other drawing, no more than kFarthestMm
  Point2 from{0, 0}, to{0, 0};
};

inline constexpr double kPenMm = 0.35;
/// Distances are not told apart beyond this.
inline constexpr double kFarthestMm = 3;

struct ClearDifferences {
  double clear_mm = 0, exact_mm = 0;  ///< drawn lengths
  std::vector<Run> added;             ///< clear ink with no exact line within the sag of the mesh there and half a pen
  std::vector<Run> outside;           ///< clear ink that lies so far outside all faces
  /// Outlines, borders and intersections of the exact drawing of the repaired mesh without clear ink so near.
  std::vector<Run> left_out;
};

/// Draws a model file in a named view on A4 by both qualities. Clear outlines are compared with the exact drawing's
/// features, all other clear lines with its visible edges of every class: hysteresis, contacts and cracks draw creases of
/// the mesh that exact features leave out. Throws what loading and drawing throw.
/// `axis`: direction of the axis, through the origin, of a part that was turned about it. Its lines may also lie on the
/// circles of which edges are chords: recognised surfaces are drawn by a finer mesh.
ClearDifferences compare_clear(const std::filesystem::path& file, std::string_view view,
                               const std::optional<Point3>& axis = std::nullopt);

/// One line for each run, for messages.
std::string text_of(const std::vector<Run>& runs);

/// How far the smooth surface that a mesh stands for may lie from the mesh, on the page.
///
/// The sag of each face: the sum over its smooth edges of w/2 tan(t/4), where t is the angle to the neighbour there and w
/// the width of the face across the edge, or the neighbour's where that is less than a fourth of it. An arc over a chord of
/// length w that turns by t rises so high over it; half of the square of a surface that bends both ways has the sum of two,
/// and the middle of a triangle less than the sum of three.
class MeshSags {
 public:
  /// The view is a parallel one. Edges that bend by more than `most_degrees` are not smooth.
  MeshSags(const Scene& scene, const Topology& topology, const View& view, double most_degrees);

  /// The largest sag of the faces that come as near to a point of the page as their sag and `within_mm`, mm of the page;
  /// nothing if there are none: the point lies outside the body.
  std::optional<double> at(Point2 p, double within_mm) const;

 private:
  struct PageTriangle {
    Point2 a, b, c;
    double sag = 0;
  };
  std::vector<PageTriangle> triangles_;
  double largest_sag_ = 0;
  std::optional<PageCells> cells_;
};

}  // namespace ligne::test
