#pragma once
/// Pairs of scenes whose drawings are the same.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "relations/plain_scene.hpp"
#include "view/view.hpp"

namespace ligne::test {

/// A scene and from where it is seen.
struct Sight {
  PlainScene scene;
  CameraRequest camera;
};

/// What a relation makes of a sight.
struct Related {
  Sight changed;
  bool mirrored = false;             ///< the drawing comes out with left and right exchanged
  std::optional<PlainScene> base{};  ///< what is drawn for comparison, when it is not the scene itself
};

struct Relation {
  std::string name;
  std::function<Related(const Sight&, bool closed_solid)> change;  ///< `closed_solid`: the first object is one, and convex
};

/// All relations. Same arguments, same results.
std::vector<Relation> all_relations();

/// Those that leave surfaces as near to each other, in proportion, as they were.
std::vector<Relation> relations_of_near_surfaces();

}  // namespace ligne::test
