#pragma once
/// The steps from the strokes of a visibility method to the lines of a drawing, in their order. docs/profiles.md tells of
/// profiles, docs/clear-lines.md of the others.

#include "contours/contour_strokes.hpp"
#include "linework/clean_lines.hpp"
#include "linework/stroke.hpp"
#include "linework/stroke_geometry.hpp"
#include "picture/prepared_scene.hpp"
#include "picture/requests.hpp"
#include "picture/run_report.hpp"
#include "scene/model/scene.hpp"
#include "scene/patches/find_patches.hpp"
#include "view/projected_scene.hpp"

namespace ligne {

/// Removes the strokes of intersections where two surfaces only touch. The triangles of a pin in its bore or a ball in
/// its race, for example, penetrate each other everywhere. Faces touch where their distance is within the errors of
/// both faces (chord_errors.hpp); `patches` are the recognised surfaces of the scene, if any. Intersections along a rim move
/// onto the rim. Counts the changes in `run`. Does nothing for exact lines. docs/clear-lines.md, "Contacts".
void clear_intersections(StrokeModel& model, const Scene& scene, const ProjectedScene& projected, const LineRequest& request,
                         const Patches& patches, RunReport& run);

/// Removes coincident strokes and, if LineRequest::least_mm requests it, cleans the lines. Counts the changes in
/// `run.clear`. `contours` is the result of draw_contours().
void tidy_strokes(StrokeModel& strokes, const PreparedScene& prepared, const ContourSources& contours, RunReport& run);

/// Cleans the lines of a scene with clean_lines() and the scene's scans and objects. No two lines may coincide. Bits
/// shorter than `least_mm` are removed. `contours` is the result of draw_contours().
CleanReport clean_scene_lines(StrokeModel& strokes, const PreparedScene& prepared, const ContourSources& contours,
                              double least_mm);

/// Returns the length of the shortest bit of a line that is drawn, in mm; 0: any.
double least_bit_mm(const PreparedScene& prepared);

/// The parts of a stroke at which the visible object ends.
struct FreeParts {
  std::vector<StrokePart> parts;  ///< sorted and disjoint
  double off_mm = 0;              ///< distance of the tested line; contours are drawn beside their mesh
};

/// The kind of profile, and the width of the pen that draws it.
struct ProfileStyle {
  ProfileKind kind;
  double pen_width_mm;
};

/// Returns for each visible stroke of an edge the parts with the paper, or another object as the kind says, on at least one
/// side. It must be visible both close to the stroke, beyond the tolerance of coincident lines, and at the distance of
/// the narrowest gap that ink leaves open.
std::vector<FreeParts> free_parts(const StrokeModel& model, const ProjectedScene& projected, const Scene& scene,
                                  const ContourSources& contours, const ProfileStyle& style);

/// Gives the class profile to the parts of the visible strokes of edges behind which an object ends, so that the paper or an
/// object farther back is visible. Call it after coincident strokes are removed.
/// `contours` is the result of draw_contours().
void draw_profiles(StrokeModel& model, const ProjectedScene& projected, const Scene& scene, const ContourSources& contours,
                   const ProfileStyle& style);

}  // namespace ligne
