#pragma once
/// Creases of the shape that a mesh stands for.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "scene/creases/crease_lines.hpp"
#include "scene/creases/sheet_edges.hpp"
#include "scene/creases/trace_creases.hpp"
#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"
#include "scene/patches/patch_edges.hpp"

namespace ligne {

/// Angles above which edges are creases, in degrees.
struct CreaseAngles {
  double faces = 30;                        ///< between normals of faces that stand for no surface that is known
  double surfaces = kSurfaceCreaseDegrees;  ///< between normals of known surfaces where they meet
};

struct Creases {
  std::vector<std::uint8_t> lines;     ///< per edge of the topology: kCreaseLine, or 0
  std::vector<PatchEdge> patch_edges;  ///< per edge
  Patches patches;                     ///< the surfaces that were found
  std::vector<WallEdge> walls;         ///< creases that are seen from one side alone
  std::vector<ScanObject> scans;       ///< objects whose creases were traced, in ascending order

  // Against the rule that every edge is a crease whose faces bend by more than the angle, or which has more than two faces:
  std::size_t smooth_by_file = 0;    ///< edges left out, since the file says that the surface runs smoothly over them
  std::size_t sharp_by_file = 0;     ///< edges added, since the file says that it does not
  std::size_t inside_surfaces = 0;   ///< edges left out inside of one surface, or where one runs into another
  std::size_t between_surfaces = 0;  ///< edges added, where surfaces meet at an angle
  std::size_t untraced = 0;          ///< edges left out of scans, since they lie on no clean line
  std::size_t traced = 0;            ///< edges added to scans, since a clean line runs over them
  std::size_t continued = 0;         ///< edges added, between two creases that they join
  std::size_t spurs = 0;             ///< edges left out that stand out from a crease
  std::size_t short_chains = 0;      ///< edges left out with chains that are short, weak and open
  double short_length = 0;           ///< of those, model units
  std::size_t straight_sheets = 0;   ///< edges left out that have more than two faces, none of which bend
};

/// Finds the creases of a finished scene (docs/clear-lines.md, "Creases").
///   1. Edges of which the file speaks (kEdgeSmooth, kEdgeSharp) are as it says: a smooth one is a crease only when its
///   faces
///      bend by more than kSurelySharp, a sharp one when they bend by more than half of `angles.faces`.
///      The edge in the middle of a narrow rounding is one when the wide sides of the rounding bend by the angle.
///   2. Other edges are creases when their faces bend by more than `angles.faces`. An edge of more than two faces is one
///   when
///      two of them bend.
///   3. Edges inside a surface that was found (patches/find_patches.hpp) are none, nor are those where surfaces run into
///   each
///      other; where surfaces meet at an angle there is a crease, whatever the faces bend by.
///   4. Where such a crease ends, it continues over edges that bend by more than half of `angles.faces`, in its direction,
///   as
///      long as that leads to another crease and is no longer than either of the two.
///   5. A single edge, shorter than a 64th of its object, that stands out from a crease that goes on without it is none, and
///   neither are connected creases that are
///      together shorter than a 16th of their object and end in the middle of a surface. That does not hold for edges that
///      bend by more than `angles.faces` + 20, or are sharp by the file, nor for what is connected with such.
/// Edges that the file hides or that only cut a polygon are none. A face without area, or as thin as the precision of its
/// coordinates, takes the normal of its neighbour across its longest edge.
Creases find_creases(const Scene& scene, const Topology& topology, const CreaseAngles& angles);

}  // namespace ligne
