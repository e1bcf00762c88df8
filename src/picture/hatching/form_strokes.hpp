#pragma once
/// Strokes that follow the form, evenly spaced on the page.

#include <array>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "picture/hatching/form_walk.hpp"

namespace ligne {

/// The tone to be drawn at a place.
struct FormTone {
  static constexpr double kNoStrokes = std::numeric_limits<double>::infinity();
  /// Distance of the strokes along the first direction, and of those along the second.
  std::array<double, 2> spacing_mm{kNoStrokes, kNoStrokes};
  std::uint32_t layer = 0;
  double pen_mm = 0.35;
};

struct FormStrokeOptions {
  double closest_mm = 1.4;   ///< of all distances
  double shortest_mm = 0;    ///< shorter strokes are left out, and specks
  double most_points = 1e7;  ///< of all strokes: std::length_error beyond
};

/// A stroke, page mm; all of it is of one layer.
struct FormStroke {
  std::uint32_t layer = 0;
  std::vector<Point2> points;
};

/// From one point of a stroke to the next, in closest distances (adjustable).
inline constexpr double kFormStep = 0.2;
/// Bytes that a point takes while strokes are placed.
inline constexpr double kFormPointBytes = 400;

/// The shape along which strokes run, and what of it is seen. All of it outlives the strokes' placement.
struct FormGround {
  const FormMesh& mesh;
  const FormField& field;
  const FormWalk& walk;
  const FormRegions& regions;
  std::span<const std::uint32_t> surfaces;  ///< by face: its smooth surface; strokes of different ones keep no distance
};

/// How far strokes of the sparsest hatching are apart, in closest distances.
inline constexpr double kSparsest = 8;

/// Strokes of evenly spaced lines of the field ([Jobard1997]), the sparsest first and then those between them, so that
/// where it is darker strokes join those of the lighter parts. They end half a pen from rims. Every region gets its
/// chance to begin a stroke.
std::vector<FormStroke> form_strokes(const FormGround& ground, std::span<const Region> seen,
                                     const std::function<FormTone(const FormPlace&)>& tone,
                                     const FormStrokeOptions& options);

}  // namespace ligne
