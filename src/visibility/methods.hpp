#pragma once
/// The methods that keep no state from view to view, each defined in its folder.

#include "visibility/method.hpp"

namespace ligne {

/// A method of one function, which compiles nothing.
class FunctionMethod final : public Method {
 public:
  using Function = VisibilityResult(const ProjectedScene& scene, const VisibilityOptions& options);
  FunctionMethod(const MethodTraits& traits, Function& function) : traits_(traits), function_(function) {}
  const MethodTraits& traits() const override { return traits_; }
  VisibilityResult compute_visibility(const ProjectedScene& scene, const VisibilityOptions& options) const override {
    return function_(scene, options);
  }

 private:
  MethodTraits traits_;
  Function& function_;
};

/// The default: tests every edge against the faces that can hide it, in object space. [Appel1967],
/// [GalimbertiMontanari1969].
const Method& appel_method();

/// Faces clip faces: the result is visible polygons with holes. [AthertonWeiler1977], [AthertonWeiler1978].
const Method& atherton_weiler_method();

/// Edges and areas by recursive subdivision of the picture. [Warnock1969], in the version for edges of [Boulle1980] 2.2.
const Method& warnock_method();
/// Largest error of its lines on the page with `--set resolution`, mm: windows are at most as large as the longer side of
/// the sheet divided by `resolution`, and everything is decided within one window.
double warnock_tolerance_mm(const Rect& sheet, unsigned resolution);

/// Spans by one of several methods, and visible edges tracked from line to line into strokes. [Watkins1970],
/// [RomneyWatkinsEvans1969], [Archuleta1972].
const Method& watkins_method();

/// The priority list: faces are sorted by depth, the sort is checked and corrected pair by pair, and faces without an order
/// are cut. [NewellNewellSancha1972].
const Method& newell_method();

/// The depth buffer: the nearest face at every pixel. [Catmull1974], in the scan-line version of [Lecture-nd] 5.1.
const Method& zbuffer_method();
/// Largest error of its lines on the page, mm: two pixels.
double zbuffer_tolerance_mm(double page_height_mm, unsigned rows);

/// The painter's algorithm: paints faces from the farthest to the nearest, each over the earlier ones.
/// [NewellNewellSancha1972], in the two simple versions of [Heulin-nd] 3 and [Lecture-nd] 3.
const Method& painter_method();

/// Back-face culling as a method by itself: enough for one convex body. [Lecture-nd] 2, [Heulin-nd] 2, [Boulle1980] 1.2.2.3.
const Method& culling_method();

/// Each edge against the convex bodies in front of it, by linear inequalities. [Roberts1963], [Boulle1980] 1.1.2.
const Method& roberts_method();

}  // namespace ligne
