#pragma once
/// Closes the steps between pieces of a curved surface that do not quite meet.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "scene/model/scene.hpp"

namespace ligne {

/// Per object, the faces with short edges.
struct NarrowFaces {
  std::vector<double> step_heights;               ///< largest heights of steps
  std::vector<std::vector<std::uint32_t>> faces;  ///< narrow_faces() for this height and for the precision
};
/// `roundings`: length of edges in precisions that are short in any case. O(n).
NarrowFaces find_narrow_faces(const Scene& scene, double roundings);

/// Programs such as OpenSCAD make threads and other curved surfaces of overlapping pieces. Where these differ by a rounding
/// or by a small overlap, needles stand between them: steps that are too low to be seen, but whose sides would be creases.
/// This function merges the ends of the short sides of such needles, and drops the faces that vanish.
///
/// A step is a run of needles, joined at their long sides, between two faces that bend like the facets of a curved surface.
/// The needles bend to both sides: narrow strips of fillets and chamfers bend to one side alone, and the faces on both sides
/// of a step in a plane do not bend. The mean height of the run, and the way of each vertex, is kStepPart of the diagonal of
/// the object at most. An object with few such needles, or few against its faces, has them by chance and keeps them.
///
/// An object in which the merges would leave edges without a second face, or with a third one, stays as it is.
///
/// Returns the number of merged vertices. Takes O(n) time.
std::size_t close_steps(Scene& scene, const NarrowFaces& narrow);

}  // namespace ligne
