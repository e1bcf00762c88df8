#pragma once
/// Options that say how faces are shown: not at all, in gray, or hatched.

#include <optional>

#include "drawing/drawing.hpp"
#include "drawing/shading.hpp"
#include "plotting/writers.hpp"
#include "scene/scene.hpp"
#include "view/view.hpp"
#include "visibility/method.hpp"

#include "cli/output_options.hpp"

namespace CLI {
class App;
}

namespace ligne {

struct FaceOptions {
  bool shade = false;              ///< PNG: faces in gray, lit from the eye
  std::optional<double> hatch_mm;  ///< distance of the closest hatch lines
  unsigned hatch_levels = kMostHatchLevels;

  bool wanted() const { return shade || hatch_mm; }
};

void add_face_options(CLI::App& app, FaceOptions& options);

/// Throws UsageError when the options do not go together, or not with the format or the method.
void check(const FaceOptions& options, OutputFormat format, const Method& method);

/// The scan lines that the faces are made of: one for each row of pixels, or those of the hatching; nothing when no faces are wanted. Throws UsageError.
std::optional<SpanLines> span_lines(const FaceOptions& options, const PlotOptions& plot);

/// Faces as a light at the eye shows them. What was not asked for is empty.
struct FacePicture {
  std::optional<GrayPicture> shaded;
  Polylines hatching;
};
FacePicture picture_faces(const FaceOptions& options, const Scene& scene, const Camera& camera, const SpanModel& spans, const PlotOptions& plot);

}  // namespace ligne
