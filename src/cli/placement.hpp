#pragma once
/// The picture's place on the page.

#include "cli/page_options.hpp"
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

/// Chooses the page's orientation and puts the camera's picture on it, in the middle of what the margins and the room leave.
/// Throws UsageError when they leave nothing.
Placement place(const Scene& scene, const Camera& camera, const PageOptions& options, const Room& room = {});

}  // namespace ligne
