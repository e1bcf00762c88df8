#pragma once
/// Sets of faces that lie in one plane.
///
/// Two adjacent faces can not tell a plane from a finely divided surface: where rounding moves corners by more than the
/// sag of a facet, each face lies in the plane of the next one. So the set decides:
///
/// 1. A connected set of such faces is flat if all of its corners lie within the roundings of one plane.
/// 2. Any other set is divided: from its largest face on, the faces within the roundings of one plane are collected,
///    and the plane is fitted again to what was collected, until no face is added.
/// 3. What was collected is flat if it hardly grows where the tolerance does. A part of a cylinder becomes twice as wide
///    at four times the tolerance, a plane between two fillets does not. Faces of curved parts stay by themselves.
///
/// Each face is collected a bounded number of times. The steps of 2 double the extent of a set, so the whole takes
/// O(n log n). Step 2 ends early where it finds hardly any plane; the faces of the sets that are left stay by themselves.

#include <cstdint>
#include <span>
#include <vector>

#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

/// The sets of an object.
struct FlatSets {
  std::vector<std::uint32_t> set_of;  ///< per face of the object: a face of its set, the same for all faces of one set
  bool has_small_faces = false;       ///< some sets may have faces that rounding has turned by more than those of `joints`
  std::uint64_t looks = 0;            ///< number of faces that step 2 has looked at
};

/// The sets of the faces of an object. `edges` are its edges, and `joints` the indices of those at which two faces lie in
/// one plane, as far as these two tell; `order` lists the faces of the object, numbered from 0, in an order that does not
/// depend on the file.
FlatSets flat_sets(const Scene& scene, const Object& object, std::span<const Edge> edges,
                   std::span<const std::uint32_t> joints, std::span<const std::uint32_t> order);

}  // namespace ligne
