#pragma once
/// A scene as nothing but points: easy to shuffle, turn, cut and write.

#include "scene/model/scene.hpp"
#include "support/page_lines.hpp"
#include "view/view.hpp"
#include "visibility/method.hpp"

namespace ligne::test {

using Contour = std::vector<Point3>;

struct PlainFace {
  std::vector<Contour> contours;  ///< the outer one, then the holes
};

struct PlainObject {
  double precision = 0;  ///< as in Object
  std::vector<PlainFace> faces;
};

struct PlainScene {
  Axis up_axis = Axis::z;
  std::vector<PlainObject> objects;
};

/// Leaves out names, materials, details and corner flags.
PlainScene plain(const Scene& scene);

/// Vertices are numbered as the faces of an object name them; equal points of an object are one vertex.
Scene to_scene(const PlainScene& plain);

// Pairs of scenes whose drawings are the same.

/// A scene and from where it is seen.
struct Sight {
  PlainScene scene;
  CameraRequest camera;
};

/// The result of a relation applied to a sight.
struct Related {
  Sight changed;
  bool mirrored = false;             ///< the drawing comes out with left and right exchanged
  std::optional<PlainScene> base{};  ///< scene drawn for comparison, when it is not the scene itself
};

struct Relation {
  std::string name;
  std::function<Related(const Sight&, bool closed_solid)> change;  ///< `closed_solid`: the first object is one, and convex
};

/// All relations. Same arguments, same results.
std::vector<Relation> all_relations();

/// Those that leave surfaces as near to each other, in proportion, as they were.
std::vector<Relation> relations_of_near_surfaces();

// The visible lines of a drawing, and by what two drawings differ.

/// A visible line on the page.
struct Line {
  LineClass line_class;
  Segment place;
};

struct LineDrawing {
  std::vector<Line> lines;
  /// How far a line may be off: two steps of the lattice for the rounding of its two ends, and the distance at which one of
  /// two lines stands for both. See docs/numerics.md.
  double tolerance_mm = 0;
};

LineDrawing drawn(const Method& method, const Sight& sight);

LineDrawing mirror_image(LineDrawing drawing);

/// The differences of two drawings that are longer than what a line may be off, and than `shortest_mm`; empty when there are
/// none.
std::string differences(const LineDrawing& expected, const LineDrawing& found, double shortest_mm = 0);

/// Writes the scene beside other temporary files, and tells the command that draws it.
std::string command(const std::string& stem, const Sight& sight, const Method& method);

/// The methods for any scene that are exact and give strokes.
std::vector<const Method*> exact_methods();

/// Whether the method promises this drawing: some find no intersections.
bool draws_well(const Method& method, const LineDrawing& drawing);

}  // namespace ligne::test
