#pragma once
/// Draws coarse meshes of recognised surfaces by a finer mesh, and names the faces and edges of the given one.

#include <memory>
#include <vector>

#include "picture/requests.hpp"
#include "scene/patches/refine/refine_scene.hpp"
#include "view/view.hpp"

namespace ligne {

struct DrawnParts;

/// A scene and the finer one that is drawn in its place.
struct GivenScene {
  const Scene& scene;       ///< as given
  std::vector<Edge> edges;  ///< of its topology, once that is no longer needed
  Patches patches;          ///< its recognised surfaces; free forms are emptied
  RefinedScene refined;     ///< its topology is empty, once that is used
};

/// Refines the recognised surfaces whose edges lie farther from them on the page than half a pen width, if the picture
/// consists of clear lines alone: hatching, fills, curves on the faces and methods that remember an earlier picture need
/// the given faces. Replaces the members of `creases`. Returns null, and changes nothing, where nothing is refined.
std::shared_ptr<GivenScene> refine_on_page(const Scene& scene, const Topology& topology, const View& view,
                                           const PictureRequest& request, Creases& creases);

/// Replaces the refined scene by the given one in everything that is kept of a drawing. Strokes on pieces of given edges and
/// inside given faces name no edge, but their own ends.
DrawnParts on_given_scene(DrawnParts parts);

}  // namespace ligne
