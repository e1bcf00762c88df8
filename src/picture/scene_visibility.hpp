#pragma once
/// The visible parts of a scene and their places on the page: the part of a picture that knows nothing of pens and files.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "contours/contour_lines.hpp"
#include "contours/shape_lines.hpp"
#include "picture/light/detail_lines.hpp"
#include "picture/marks/axes.hpp"
#include "picture/requests.hpp"
#include "picture/run_report.hpp"
#include "scene/creases/find_creases.hpp"
#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"
#include "view/cull.hpp"
#include "view/projected_scene.hpp"
#include "visibility/common/facet.hpp"
#include "visibility/method.hpp"

namespace ligne {

/// A scene made ready for a study.
struct PreparedScene {
  const Scene& scene;
  const PictureRequest& request;
  const Method& method;
  Topology topology;
  Surroundings around;  ///< with the place of the picture on the page
  ProjectedScene projected;
  BackFaces back_faces;            ///< left out of `projected`
  std::vector<Light> lights;       ///< that cast shadows
  std::optional<Facets> facets{};  ///< of `projected`, where they were made beside something else
  SmoothContours contours{};       ///< in place of outlines of meshes
  ShapeLines shape_lines{};
  std::vector<ScanObject> scans{};
  Patches patches{};                              ///< the surfaces that clear creases found, without free forms
  std::vector<std::uint32_t> object_edge_ends{};  ///< by object: the end of its edges, which follow those before it
  std::uint32_t first_probe = 0;                  ///< source of the first probe of a point (LineGroups)
  std::vector<DetailLine> details{};
  std::uint32_t first_detail = 0;  ///< source of the first of them

  const View& view() const { return around.placement.view; }
};

/// The findings. Every stroke is there once, and regions carry details and light.
struct SceneVisibility {
  const Method* method = nullptr;  ///< by which it was found
  VisibilityResult result;
  std::vector<Edge> edges;                     ///< of the scene, where `keep_edges` asks for them
  std::vector<std::array<Point3, 2>> lines{};  ///< beside them (LineGroups), the same
  std::vector<std::uint8_t> points_seen{};     ///< of those of LineGroups
  std::vector<DetailLine> details{};           ///< of the scene, the same as `edges`
  std::uint32_t first_detail = 0;              ///< source of the first of them

  /// The source of a stroke: an edge of the scene, an intersection or the border of a shadow.
  SourceEdge source(const Scene& scene, std::uint32_t number) const;
};

/// The method that gives what the picture is made of: the one asked for; else, for fills, hatching and shadows, the first
/// that gives regions; else the default one, in whose place another one may draw the lines (method_choice.hpp).
const Method& method_of(const PictureRequest& request);

/// Fills are painted from the back to the front, since the method gives an order, and no light casts shadows.
bool paints_in_order(const PictureRequest& request, const Method& method);

/// Products that the picture is made of; a JSON drawing holds all that there are but pixels.
std::uint8_t wanted_products(const PictureRequest& request, const Method& method);

/// The picture needs regions of its method.
bool wants_regions(const PictureRequest& request, const Method& method);

/// Topology, camera, place on the page, projection, culling. `box`: what axes measure. `topology`: that of the scene, where
/// it is known. Throws RequestError.
PreparedScene prepare(const Scene& scene, const PictureRequest& request, const std::optional<PlotBox>& box, RunReport& run,
                      std::optional<Topology> topology = {});

/// The method's study, with details and light on its regions. Empties `prepared.topology`, whose memory the study needs.
/// `span_lines`: where spans are wanted. Throws RequestError.
SceneVisibility compute_visibility(PreparedScene& prepared, std::optional<SpanLines> span_lines, bool keep_edges,
                                   RunReport& run);

}  // namespace ligne
