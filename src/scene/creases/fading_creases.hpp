#pragma once
/// Creases that end in the middle of a free form.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "scene/creases/bend.hpp"
#include "scene/creases/parallel_bends.hpp"
#include "scene/model/edge_rows.hpp"
#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

/// The edges that bend, and which of them may fade.
struct FadingEdges {
  const EdgeRows& rows;
  std::span<const BendEnd> ends;                        ///< sorted
  std::span<const double> sizes;                        ///< per object: diagonal of its box
  std::span<const std::uint8_t> is_freeform;            ///< per face
  const std::function<bool(std::uint32_t)>& may_fade;   ///< by edge of two faces
  const std::function<bool(std::uint32_t)>& is_anchor;  ///< by vertex of an end: a crease may end here
};

/// Takes back creases across which a free form bends on alike (turn_across()), as an irregular mesh of a tube has them, and
/// creases that end in the middle of a free form, in objects that are free forms to three quarters of their area
/// and in regions that are large for their borders: they have three times the area of discs that are as long about as these.
/// A coarse mesh of a smooth surface bends by more than the crease angle in many places; the creases there end where the
/// bend happens to be less.
///
/// A run leads from a free end to the next vertex of three creases or more, to an anchored one, or to an edge that does not
/// fade, as those above a right angle and those beside planes. It is cut back to the first of its edges that stands out:
/// because it bends by more than a turn of eight facets does, or because on one side of it no parallel edge bends to the
/// same side by two fifths as much or more, or four times as far away as on the other. It goes if what stays is shorter than
/// a quarter of its object, or an eighth where it bends by 60 degrees on average. This is repeated at the ends that it
/// leaves. At last connected creases go that are no sharper than the form around them (drop_blunt_creases() in
/// loose_creases.hpp). Edges that go are weak then. Returns their number. Independent of the order of edges: each pass
/// judges the creases that the last one left.
std::size_t drop_fading_creases(const Scene& scene, const Topology& topology, const FadingEdges& edges,
                                std::vector<Bend>& bends);

}  // namespace ligne
