#pragma once
/// Merges vertices that lie so near each other that their coordinates do not tell the directions of the faces between
/// them.

#include <cstddef>

#include "scene/model/scene.hpp"

namespace ligne {

/// Some programs write meshes whose triangles are hardly wider than a step of their coordinates, such as a fillet of a
/// hundred strips in hundredths of a millimetre. The directions of such triangles are those of the roundings: their sides
/// would be creases and outlines, and no surface is found in them. So vertices of thin triangles are merged with neighbours,
/// or edges flipped, one after another, those at the thinnest triangle first. Each vertex that has gone lies within the
/// errors of two rounded points of the faces that are left, and no face is turned over: the mesh reduction of
/// [KleinLiebichStrasser1996]. Vertices on borders stay. Only objects of triangles without marks at their corners are
/// changed, a quarter of whose triangles are so thin.
///
/// Returns the number of merged vertices. Takes O(n log n) time, with a bound on the work at vertices of many faces.
std::size_t merge_fine_vertices(Scene& scene);

}  // namespace ligne
