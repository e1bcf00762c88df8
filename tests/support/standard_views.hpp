#pragma once
/// The views from which every scene of the corpus is drawn.

#include <string>
#include <vector>

#include "view/view.hpp"

namespace ligne::test {

struct StandardView {
  std::string name;
  CameraRequest camera;
  /// The view on the command line: "--direction=-1,1,-1".
  std::string options;
};

/// Four parallel views (isometric, an odd direction, a dimetric-like one, along an axis), two perspectives from outside the
/// scene's bounding sphere, at 2.2 and 1.4 radii from its centre, and one from inside its bounding box.
std::vector<StandardView> standard_views(const Scene& scene);

}  // namespace ligne::test
