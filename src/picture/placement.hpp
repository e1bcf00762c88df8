#pragma once
/// Placement of the picture on the page.

#include "picture/requests.hpp"
#include "scene/model/scene.hpp"
#include "view/view.hpp"

namespace ligne {

/// Space that is kept free around the picture for axes and texts, in mm.
struct Insets {
  double left = 0, top = 0, right = 0, bottom = 0;
};

/// The picture that a camera takes of a scene, before it has a place on the page.
struct CameraPicture {
  Camera camera;
  Rect extent;         ///< the area to fit to the page, see projected_extent()
  double unit_mm = 1;  ///< true length of a model unit
};

struct Placement {
  Page page;
  View view;
  Rect picture;  ///< page mm: extent of the whole scene before clipping; empty if nothing is in view

  /// Whether a part of the picture lies outside the sheet and is clipped away.
  bool larger_than_page() const;
};

/// Throws RequestError if the margins leave no drawable area.
void check(const PageRequest& request);

/// The requested camera. Throws RequestError if the request is invalid for this scene.
Camera camera_of(const ViewRequest& request, const Scene& scene);

/// The picture that the requested camera takes. Its extent is the requested one, else that of the scene. Throws
/// RequestError if the request is invalid for this scene.
CameraPicture picture_of(const ViewRequest& view, const PageRequest& page, const Scene& scene);

/// The page with its orientation: the requested one, else the one in which a picture of this extent is larger. If both
/// are equal, the page keeps the orientation in which it is defined.
Page page_for(const PageRequest& request, const Rect& extent);

/// Chooses the orientation of the page, and centres the picture in the area that margins and insets leave. Throws
/// RequestError if they leave no area.
Placement place(const CameraPicture& picture, const PageRequest& request, const Insets& insets = {});

}  // namespace ligne
