#pragma once
/// The visible parts of a scene and their places on the page: the part of a picture that knows nothing of pens and files.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "contours/contour_strokes.hpp"
#include "picture/light/detail_lines.hpp"
#include "picture/prepared_scene.hpp"
#include "picture/run_report.hpp"
#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"
#include "visibility/method.hpp"

namespace ligne {

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

/// Every line as its method finds it, visible or hidden. Empties `prepared.topology`, whose memory the method needs.
/// `span_lines`: where spans are wanted. `keep_edges`: source() is asked later. Throws RequestError.
SceneVisibility compute_visibility(PreparedScene& prepared, std::optional<SpanLines> span_lines, bool keep_edges,
                                   RunReport& run);

/// From the strokes of a method to the lines of a drawing: contours and lines of the shape in their places, no line twice,
/// profiles cut, and details and light on regions. Throws RequestError.
void finish_lines(SceneVisibility& found, PreparedScene& prepared, RunReport& run);

}  // namespace ligne
