#pragma once
/// The visible parts of a scene on the page. This part of the program does not depend on pens or files.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "contours/contour_strokes.hpp"
#include "picture/light/details.hpp"
#include "picture/prepared_scene.hpp"
#include "picture/run_report.hpp"
#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"
#include "visibility/method.hpp"

namespace ligne {

/// The result of a visibility method. After finish_lines() no two strokes coincide, and regions carry details and
/// light.
struct SceneVisibility {
  const Method* method = nullptr;  ///< the method that was used
  VisibilityResult result;
  std::vector<Edge> edges;                     ///< edges of the scene; empty without `keep_edges`
  std::vector<std::array<Point3, 2>> lines{};  ///< LineGroups::lines; empty without `keep_edges`
  std::vector<std::uint8_t> points_seen{};     ///< per point of LineGroups::points: 1 if it is visible
  std::vector<DetailLine> details{};           ///< contours of details; empty without `keep_edges`
  std::uint32_t first_detail = 0;              ///< source of the first detail line

  /// The source of a stroke by its number: an edge of the scene, a line of LineGroups, a detail line, an intersection
  /// or a border of a shadow. Requires `keep_edges`.
  SourceEdge source(const Scene& scene, std::uint32_t number) const;
};

/// Runs the visibility method over all candidate lines. Empties `prepared.topology`, because the method needs its
/// memory. `span_lines`: the scan lines for which spans are wanted, if any. `keep_edges`: whether source() will be
/// called later. Throws RequestError.
SceneVisibility compute_visibility(PreparedScene& prepared, std::optional<SpanLines> span_lines, bool keep_edges,
                                   RunReport& run);

/// Turns the strokes of a method into the lines of a drawing. It replaces the lines that stood for smooth contours and
/// shape lines, removes coincident strokes, cuts profiles out of lines, and adds details and light to regions. Throws
/// RequestError.
void finish_lines(SceneVisibility& found, PreparedScene& prepared, RunReport& run);

}  // namespace ligne
