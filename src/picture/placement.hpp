#pragma once
/// The picture's place on the page.

#include "picture/requests.hpp"
#include "scene/model/scene.hpp"
#include "view/view.hpp"

namespace ligne {

/// Room beside the picture for what is written round it, in mm.
struct Room {
  double left = 0, top = 0, right = 0, bottom = 0;
};

struct Placement {
  Page page;
  View view;
  Rect picture;  ///< page mm that the whole scene takes, before anything is clipped; empty when nothing is in view

  /// Something lies outside the sheet and is clipped away.
  bool larger_than_page() const;
};

/// Throws RequestError when the margins leave nothing of the page.
void check(const PageRequest& request);

/// The camera asked for. Throws RequestError where the request has no meaning for this scene.
Camera camera_of(const ViewRequest& request, const Scene& scene);

/// The page in its orientation: as asked for, else that in which a picture of this extent becomes larger (as the page is
/// named when both are alike).
Page page_for(const PageRequest& request, const Rect& extent);

/// Chooses the page's orientation and puts the camera's picture, of that extent (see projected_extent), on it, in the middle
/// of what the margins and the room leave. `unit_mm`: true length of a model unit. Throws RequestError when they leave
/// nothing.
Placement place(const Rect& extent, double unit_mm, const Camera& camera, const PageRequest& request, const Room& room = {});

/// Places by the extent of the scene.
Placement place(const Scene& scene, const Camera& camera, const PageRequest& request, const Room& room = {});

}  // namespace ligne
