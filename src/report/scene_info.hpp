#pragma once
/// The contents of a scene, and how each method can draw it.

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "linework/stroke.hpp"
#include "picture/choice/scene_traits.hpp"
#include "picture/models/models.hpp"
#include "picture/placement.hpp"
#include "report/surface_facts.hpp"
#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"
#include "view/cull.hpp"
#include "view/projected_scene.hpp"
#include "visibility/method.hpp"

namespace ligne {

/// Facts about a scene that do not depend on a method.
struct ObjectFacts {
  std::string name;
  std::size_t vertices = 0, faces = 0;
  std::vector<std::size_t> materials;  ///< materials of its faces, by index, ascending
  std::size_t border_edges = 0;        ///< edges of one face
  std::size_t many_face_edges = 0;     ///< edges of more than two faces
  std::size_t unlike_wound_edges = 0;  ///< edges whose two faces disagree on which side is outside

  /// Whether every edge has two faces.
  bool closed() const { return faces > 0 && border_edges == 0 && many_face_edges == 0; }
  /// Whether it is closed and the windings agree, so that back faces may be culled.
  bool solid() const { return closed() && unlike_wound_edges == 0; }
};

struct MaterialFacts {
  std::string name;
  Point3 color{0, 0, 0};
  double opacity = 1;
  std::size_t faces = 0;
};

struct SceneFacts {
  std::size_t vertices = 0, faces = 0, faces_with_holes = 0, triangles = 0, edges = 0;
  std::array<Point3, 2> bounds{};  ///< least and greatest corner; both zero if there is no vertex
  double precision = 0;            ///< largest precision of an object
  std::vector<ObjectFacts> objects{};
  std::vector<MaterialFacts> materials{};

  /// The sum of a count over all objects.
  std::size_t sum(std::size_t ObjectFacts::*member) const {
    std::size_t n = 0;
    for (const ObjectFacts& object : objects) n += object.*member;
    return n;
  }
};

/// Counts over a finished scene and its topology.
SceneFacts scene_facts(const Scene& scene, const Topology& topology);

struct ViewFacts {
  std::array<std::size_t, kLineClassCount> edges{};  ///< candidate edges of each class
  double nearest = 0, farthest = 0;                  ///< along the line of sight from the viewer or the centre, model units
};

/// Counts over a scene projected with all classes selected. A source edge that clipping cut counts once.
ViewFacts view_facts(const Scene& scene, const ProjectedScene& projected);

/// Which facts that spare tests hold of a scene, so that its file or --assume can state them ([Boulle1980] 1.2.2.1).
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

struct SceneInfo {
  SceneFacts scene;
  ViewFacts view;
  SceneTraits traits;
  KnownFacts known;
  SurfaceFacts surfaces;            ///< recognised behind the meshes, for clear lines
  std::optional<BackFaces> culled;  ///< only if culling is requested
  Placement placement;
  Axis up_axis = Axis::z;
  bool up_axis_is_given = false;   ///< by the request
  const Method* method = nullptr;  ///< the method that would draw the scene
};

/// Analyses the models as for a picture. Throws RequestError.
SceneInfo scene_info(const LoadedModels& models, const ViewRequest& view, const LineRequest& lines, const PageRequest& page,
                     RunReport& run);

/// The information as a table for people.
std::string info_text(const LoadedModels& models, const SceneInfo& info);

/// The information as JSON: {"format": "ligne-info", "version": 1, "files", "scene", "view", "methods"}.
std::string info_json(const LoadedModels& models, const SceneInfo& info);

/// Describes which scenes a method can draw, from its traits.
std::string meaning_for(const MethodTraits& traits);

/// Colour code such as "#c0c0c0" of red, green and blue from 0 to 1.
std::string color_code_of(const Point3& color);

/// Returns names and values, in order.
std::vector<std::pair<std::string, std::string>> lines_of(const SceneTraits& traits);

/// Formats the traits as JSON. A count that was stopped is {"at_least": N}.
nlohmann::ordered_json json_of(const SceneTraits& traits);

}  // namespace ligne
