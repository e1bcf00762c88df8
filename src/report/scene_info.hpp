#pragma once
/// The contents of a scene, and how each method can draw it.

#include <optional>
#include <string>

#include "picture/choice/scene_traits.hpp"
#include "picture/models/models.hpp"
#include "picture/placement.hpp"
#include "report/known_facts.hpp"
#include "report/scene_facts.hpp"
#include "report/surface_facts.hpp"
#include "view/cull.hpp"
#include "visibility/method.hpp"

namespace ligne {

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

}  // namespace ligne
