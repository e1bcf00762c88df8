#pragma once
/// Hatching strokes that follow the form, evenly spaced on the page.

#include <array>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "picture/hatching/form_walk.hpp"

namespace ligne {

/// The tone of a place.
struct FormTone {
  static constexpr double kNoStrokes = std::numeric_limits<double>::infinity();
  /// Spacing of the strokes along the first and along the second direction of the field.
  std::array<double, 2> spacing_mm{kNoStrokes, kNoStrokes};
  std::uint32_t layer = 0;
  double pen_mm = 0.35;
};

struct FormStrokeOptions {
  double closest_mm = 1.4;   ///< smallest spacing
  double shortest_mm = 0;    ///< shorter strokes are left out
  double most_points = 1e7;  ///< limit for all strokes together; beyond it form_strokes() throws std::length_error
};

/// A stroke in page mm, all of one layer.
struct FormStroke {
  std::uint32_t layer = 0;
  std::vector<Point2> points;
};

/// Step between points of a stroke, in smallest spacings. Adjustable.
inline constexpr double kFormStep = 0.2;
/// Memory for each point while strokes are placed, in bytes.
inline constexpr double kFormPointBytes = 400;

/// The surface along which strokes run, and its visible parts. All members must outlive the placement of strokes.
struct FormGround {
  const FormMesh& mesh;
  const FormField& field;
  const FormWalk& walk;
  const FormRegions& regions;
  /// By face: its smooth surface. Strokes of different surfaces keep no distance.
  std::span<const std::uint32_t> surfaces;
};

/// Spacing of the sparsest hatching, in smallest spacings.
inline constexpr double kSparsest = 8;

/// Makes evenly spaced strokes along lines of the field ([Jobard1997]), the sparsest first and then those between them,
/// so that strokes of lighter parts continue into darker parts. They may begin in any region, and end half a pen width
/// before the rim of the visible surface.
std::vector<FormStroke> form_strokes(const FormGround& ground, std::span<const Region> seen,
                                     const std::function<FormTone(const FormPlace&)>& tone,
                                     const FormStrokeOptions& options);

}  // namespace ligne
