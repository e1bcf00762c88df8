#pragma once
/// Models that scripts name by their shape.

#include <string>
#include <vector>

namespace ligne::test {

/// The OBJ of a shape, by its name and its numbers:
///
///     torus; covered-torus     lying, its ring of radius 60 and its tube of 25; with a plate before half of it
///     disc N                   a polygon of N corners on the unit circle
///     scanned-ball N NOISE     six grids of N x N squares, blown up to a unit ball, whose points are off it at random
///     bored-plate R R; turned-part; ball; rounded-box X Y Z N     see tests/patches
std::string obj_of_shape(const std::vector<std::string>& words);

}  // namespace ligne::test
