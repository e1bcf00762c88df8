#pragma once
/// Successive views of one model: the pictures of a film, of a model that is turned by hand, or of a walk through it.

#include <functional>
#include <optional>
#include <vector>

#include "picture/draw_scene.hpp"

namespace ligne {

struct FrameRequest {
  unsigned count = 1;
  double turn_degrees = 360;  ///< frame i is turned by i / count of it
  bool as_pages = false;      ///< those of a PDF become pages of one document
  /// The way of the eye, as a polyline in model space: the frames stand on it from its beginning to its end, equally far
  /// apart. Empty: the model turns.
  std::vector<Point3> eyes{};
  bool looks_ahead =
      false;  ///< the line of sight is the direction of that way; otherwise the view's own target is looked at
};

/// Draws the frames and hands each to take(), in their order; a document of several pages is handed over once. Topology, and
/// what the method compiles, do not depend on the view, and are made once. All frames of a turning model have one scale and
/// one place on the page, so that it turns about an axis that stands still; those of a moving eye have one field of view,
/// which fills the page. Counts and times of `run` are sums over all frames; a warning that several frames give is there
/// once. Throws as draw_scene() does.
void draw_frames(const Scene& scene, PictureRequest request, const FrameRequest& frames, RunReport& run,
                 std::optional<Topology> topology, const std::function<void(Picture)>& take);

}  // namespace ligne
