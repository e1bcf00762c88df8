#pragma once
/// Successive views of one model: the pictures of a film, or of a model that is turned by hand.

#include <functional>
#include <optional>

#include "picture/draw_scene.hpp"

namespace ligne {

struct FrameRequest {
  unsigned count = 1;
  double turn_degrees = 360;  ///< frame i is turned by i / count of it
  bool as_pages = false;      ///< those of a PDF become pages of one document
};

/// Draws the frames and hands each to take(), in their order; a document of several pages is handed over once. Topology, and
/// what the method compiles, do not depend on the view, and are made once. All frames have one scale and one place on the
/// page, so that the model turns about an axis that stands still. Counts and times of `run` are sums over all frames; a
/// warning that several frames give is there once. Throws as draw_scene() does.
void draw_frames(const Scene& scene, PictureRequest request, const FrameRequest& frames, RunReport& run,
                 std::optional<Topology> topology, const std::function<void(Picture)>& take);

}  // namespace ligne
