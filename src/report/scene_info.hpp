#pragma once
/// The contents of a scene, and their meaning for each method.

#include <optional>
#include <string>

#include "picture/choice/scene_traits.hpp"
#include "picture/models/models.hpp"
#include "picture/placement.hpp"
#include "report/scene_facts.hpp"
#include "report/surface_facts.hpp"
#include "view/cull.hpp"
#include "visibility/method.hpp"

namespace ligne {

struct SceneInfo {
  SceneFacts scene;
  ViewFacts view;
  SceneTraits traits;
  SurfaceFacts surfaces;            ///< behind the meshes, for clear lines
  std::optional<BackFaces> culled;  ///< when that was asked for
  Placement placement;
  Axis up_axis = Axis::z;
  const Method* method = nullptr;  ///< that would draw it
};

/// Looks at the models as at a picture of them. Throws RequestError.
SceneInfo scene_info(const LoadedModels& models, const ViewRequest& view, const LineRequest& lines, const PageRequest& page,
                     RunReport& run);

/// As a table for people.
std::string info_text(const LoadedModels& models, const SceneInfo& info);

/// As JSON: {"format": "ligne-info", "version": 1, "files", "scene", "view", "methods"}.
std::string info_json(const LoadedModels& models, const SceneInfo& info);

/// The meaning of a scene for a method, as far as its traits say.
std::string meaning_for(const MethodTraits& traits);

/// "#c0c0c0" of red, green and blue from 0 to 1.
std::string color_code_of(const Point3& color);

}  // namespace ligne
