#pragma once
/// How a mesh bends on the two sides of a line of edges.

#include <cstddef>
#include <optional>
#include <span>

#include "scene/patches/borders/seam_section.hpp"

namespace ligne {

/// An edge of a line. The first side of its section lies to the left of the way along the line.
struct LineSection {
  double length = 0;
  std::optional<SeamSection> section{};  ///< nothing where the faces near the edge do not determine it
};

/// The bend along a line. Of its sides, that of the smaller median curvature is the flat one, and the other the round one.
struct LineBend {
  std::size_t edges = 0;
  double length = 0;
  double measured = 0;  ///< part of the length that has sections
  /// Part of the measured length where the flat side bends less than half as much as the round one, and that bends to its
  /// usual side: where a tube begins to bend, it is round on one side of the tube and hollow on the other.
  double agreeing = 0;
  double ratio = 0;   ///< median curvature of the flat side, divided by that of the round one
  double turn = 0;    ///< median angle by which the round side turns over its first face, radians
  double depth = 0;   ///< median depth of the faces of the round side, model units
  double depths = 0;  ///< median depth of the faces of the flat side, in those of the round one
  double error = 0;   ///< median error of the sections, as a fraction of twice the sag of the faces of the round side

  /// Whether the curvature jumps from one side to the other. One section may be wrong where faces are irregular; the medians
  /// of a line are not.
  bool may_be_seam() const;
  /// Whether one side is nearly flat and the other one clearly round.
  bool is_clear() const;
  /// Whether both sides bend alike, or hardly at all.
  bool is_even() const;
  /// Whether the sections of nearly the whole line agree.
  bool is_whole() const;
};

LineBend bend_along(std::span<const LineSection> sections);

}  // namespace ligne
