#pragma once
/// Selects the lights, and applies details and shadows to the regions of a method.

#include <vector>

#include "picture/requests.hpp"
#include "picture/run_report.hpp"
#include "scene/model/scene.hpp"
#include "visibility/method.hpp"

namespace ligne {

struct PreparedScene;

/// Returns the lights that cast shadows: those of the request; if it has none and the picture shows light or shadows,
/// those of the scene.
std::vector<Light> lights_of(const PictureRequest& request, const Scene& scene);

/// Cuts the regions along the scene's details and shadows. Adds the borders of the shadows to the strokes if the class
/// `shadow` is drawn. Throws RequestError if shadows are requested without a light.
void light_regions(const PreparedScene& prepared, VisibilityResult& result, RunReport& run);

}  // namespace ligne
