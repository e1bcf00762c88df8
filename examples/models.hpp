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

}  // namespace ligne::examples
