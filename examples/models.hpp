#pragma once
/// The example models.

#include "solid.hpp"

namespace ligne::examples {

/// A spur gear and its pinion before a bearing plate, in mm: involute teeth, web with holes, bore with keyway, shaft,
/// socket-head screws. Faces with many holes; the shaft and the screws penetrate the plate.
Model gear_pair();

/// A reducing pipe tee with three flanges, studs and nuts, in mm: penetrating cylinders.
Model pipe_tee();

/// A spiral staircase in a domed rotunda, in m: thin slats, a helical rail, slender columns. No faces with holes.
Model stair_tower();

/// The compound of five cubes in one dodecahedron, in mm: every face is crossed by faces of all the other cubes.
Model five_cubes();

/// A tube along a trefoil knot on a torus, in mm: one closed mesh of triangles that hides much of itself.
Model trefoil();

}  // namespace ligne::examples
