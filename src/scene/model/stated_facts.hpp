#pragma once
/// Facts about a scene that its file or its user states: they do not depend on the view, and spare tests.
///
/// [Boulle1980] 1.2.2.1. docs/scene-format.md says which tests.

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "geometry/point.hpp"

namespace ligne {

enum class StatedFact : std::uint8_t {
  no_penetration,  ///< no two faces pass through each other
  convex,          ///< every object is one closed convex body
  adjacency,       ///< each side of a face is, in the opposite direction, a side of exactly one other face
};
inline constexpr std::array<std::string_view, 3> kStatedFactNames{"no-penetration", "convex", "adjacency"};

/// A plane that has every object wholly on one side.
struct SeparatingPlane {
  Point3 point{0, 0, 0};
  Point3 normal{0, 0, 1};  ///< unit vector
};
/// Most planes of a scene: painting sorts by a key with one bit per plane.
inline constexpr std::size_t kMostSeparatingPlanes = 32;

struct StatedFacts {
  std::uint8_t bits = 0;  ///< a bit for each StatedFact
  std::vector<SeparatingPlane> planes{};

  bool has(StatedFact fact) const { return (bits >> static_cast<unsigned>(fact)) & 1; }
  void state(StatedFact fact) { bits = static_cast<std::uint8_t>(bits | bit(fact)); }
  void withdraw(StatedFact fact) { bits = static_cast<std::uint8_t>(bits & ~bit(fact)); }
  bool any() const { return bits != 0 || !planes.empty(); }
  /// Whether a fact says where faces lie, so that it may be false of a finer mesh of the same surfaces.
  bool any_of_shape() const { return (bits & ~bit(StatedFact::adjacency)) != 0 || !planes.empty(); }
  /// Withdraws the facts that concern two objects: objects were moved, or others were added.
  void forget_relations() {
    withdraw(StatedFact::no_penetration);
    planes.clear();
  }

 private:
  static constexpr unsigned bit(StatedFact fact) { return 1u << static_cast<unsigned>(fact); }
};

}  // namespace ligne
