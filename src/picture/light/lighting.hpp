#pragma once
/// Light: which lights there are, and what details and shadows make of the regions of a study.

#include <vector>

#include "picture/requests.hpp"
#include "picture/run_report.hpp"
#include "scene/model/scene.hpp"
#include "visibility/method.hpp"

namespace ligne {

struct PreparedScene;

/// Lights that cast shadows: those of the request; without any, those of the scene, where the picture shows light or
/// shadows.
std::vector<Light> lights_of(const PictureRequest& request, const Scene& scene);

/// Cuts the regions by the scene's details and by what each light reaches, and adds the borders of the shadows to the
/// strokes where class `shadow` is drawn. Throws RequestError where regions are wanted and the method gives none, or shadows
/// and there is no light.
void light_regions(const PreparedScene& prepared, VisibilityResult& result, RunReport& run);

}  // namespace ligne
