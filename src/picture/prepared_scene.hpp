#pragma once
/// A scene made ready for its method: topology, place on the page, candidate lines, contours.

#include <cstdint>
#include <optional>
#include <vector>

#include "contours/contour_lines.hpp"
#include "contours/shapes/shape_lines.hpp"
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

/// The scene itself must outlive this.
struct PreparedScene {
  const Scene& scene;
  PictureRequest request;
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

/// Prepares a scene. `box`: what axes measure. `topology`: that of the scene, where it is known. Throws RequestError.
PreparedScene prepare(const Scene& scene, PictureRequest request, const std::optional<PlotBox>& box, RunReport& run,
                      std::optional<Topology> topology = {});

/// The contours of smooth regions at this page and pen width, whose borders are the creases that were found.
ContourOptions contour_options(const PictureRequest& request, const Creases& creases);

}  // namespace ligne
