#pragma once
/// Which facts that spare tests hold of a scene, so that its file or --assume can state them ([Boulle1980] 1.2.2.1).

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

#include "picture/choice/scene_traits.hpp"
#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

struct KnownFact {
  StatedFact fact = StatedFact::no_penetration;
  bool stated = false;  ///< by the file or the user
  std::string why_not;  ///< empty if nothing shows that it is false
  bool certain = true;  ///< false if it was not found false, but not everything was tested
};

struct KnownFacts {
  std::vector<KnownFact> facts;  ///< in the order of kStatedFactNames
  /// Planes that have every object on one side: those that are stated, or else one across each axis of the model in the
  /// middle of each gap between objects; at most kMostSeparatingPlanes.
  std::vector<SeparatingPlane> planes;
  bool planes_stated = false;

  /// The facts that certainly hold, as the value of --assume; may be empty.
  std::string assumable() const;
};

/// Tests all facts. Penetrations are those that the traits count, and those of the check of stated facts.
KnownFacts known_facts(const Scene& scene, const Topology& topology, const SceneTraits& traits);

/// Returns names and values, in order.
std::vector<std::pair<std::string, std::string>> lines_of(const KnownFacts& known);

/// Formats the facts as JSON. The planes are as in `separating_planes` of a scene.
nlohmann::ordered_json json_of(const KnownFacts& known);

}  // namespace ligne
