#pragma once
/// Faces in gray.

#include <optional>

#include "drawing/drawing.hpp"
#include "drawing/shading.hpp"
#include "plotting/writers.hpp"
#include "scene/model/scene.hpp"
#include "view/view.hpp"
#include "visibility/method.hpp"

#include "cli/output_options.hpp"

namespace CLI {
class App;
}

namespace ligne {

struct FaceOptions {
  bool shade = false;  ///< PNG: faces in gray, lit from the eye
};

void add_face_options(CLI::App& app, FaceOptions& options);

/// Throws UsageError when the options do not go together, or not with the format or the method.
void check(const FaceOptions& options, OutputFormat format, const Method& method);

/// The scan lines that the faces are made of, one for each row of pixels; nothing when no faces are wanted.
std::optional<SpanLines> span_lines(const FaceOptions& options, const PlotOptions& plot);

/// Faces as a light at the eye shows them.
GrayPicture picture_faces(const Scene& scene, const Camera& camera, const SpanModel& spans, const PlotOptions& plot);

}  // namespace ligne
