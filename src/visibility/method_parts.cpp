#include "visibility/method_parts.hpp"

#include <algorithm>
#include <iterator>

namespace ligne {
namespace {

struct PartsOfMethod {
  std::string_view method;
  SevenParts parts;
};

constexpr PartsOfMethod kPartsOfMethods[] = {
    {"appel",
     {"`ProjectedScene`: triangles of plane faces with holes, vertices on the page lattice with depth; "
      "candidate lines, that is edges of the selected classes. Faces may touch, penetrate, coincide, overlap in "
      "rings. Opacity, lights and details are ignored",
      "vertices along a Morton curve over the page [Morton1966], triangles and edges by their lowest vertex; "
      "counting sorts, or sorts of few vertices (`spatial_order.cpp`)",
      "line against facet (`hidden_interval.hpp`); facet against square (`meet` in `facet_in_cell.hpp`); corner "
      "against plane and segment against facet (`Heights::over`, `common_segment` in `penetration.cpp`)",
      "cell by cell along the line, nearest facet first, until nothing of the line is left",
      "the list of each cell by nearest depth; intervals that cover one side of the line by their ends, where "
      "there are several; pairs of penetrating facets by their numbers",
      "facets; grid of cells with lists and occluders; open parts of a line in a cell",
      "strokes (`StrokeModel`): pieces of lines, visible or hidden as a whole"}},
    {"atherton-weiler",
     {"`ProjectedScene`: triangles of plane faces with holes, vertices on the page lattice with depth; which "
      "faces are transparent. Faces may touch, penetrate, coincide, overlap in rings",
      "cells of the page (`cell_grid.hpp`), the facets of each from the nearest on; what lies behind a facet "
      "that covers the cell is not listed",
      "order of two facets where they overlap (`facet_order.cpp`); clip of a face by faces (`edge_overlay.hpp`, "
      "`facet_clip.cpp`, `link_edges.cpp`)",
      "every facet is the subject once; the facets of its cells clip it, nearest first, up to where the subject "
      "ends in depth. Or, `--set study=polygons`, the classical study",
      "crossings along an edge, exactly; edges of a border by where they begin",
      "contours as runs on source segments (`contour_face.hpp`); windows with the clip faces that meet them",
      "regions (`Region`) with level, lights and material; strokes (`StrokeModel`)"}},
    {"warnock",
     {"`ProjectedScene`: plane faces, convex or not, with holes or without, which may touch and penetrate; "
      "candidate edges",
      "faces by nearest depth, then by number (`FaceTable::by_depth`): O(n log n)",
      "face against window (`relation_to`): edges against a rectangle, and the winding number of the contours "
      "round a point of it, exact; depth of a face against the plane of another over the window "
      "(`compare_depth`); line against facet (`hidden_interval.hpp`); facet against facet (`penetration.cpp`)",
      "analysis, understanding; drawn, solved, or divided in four, each child by itself",
      "none of faces: lists keep the initial order from parent to child. Facets of a window that is drawn, by "
      "depth; visible parts by line and parameter",
      "the lists of a window: surrounders and intersectors with their nearest depths there, and the depth "
      "behind which nothing is seen; pieces of lines",
      "strokes (`StrokeModel`), and regions, one for each visible connected piece of a face, with its holes"}},
    {"watkins",
     {"`ProjectedScene`: plane faces with holes on the page lattice, that may penetrate, coincide, overlap in "
      "rings; candidate lines",
      "`exact`: points of the page in scan order, edges under the point where they begin (`sweep_scene.cpp`). "
      "Lines: edges in buckets by the first line that meets them (`scan_scene.cpp`)",
      "point against edge, by exact determinants; two edges, where they cross; depth of two segments at the "
      "ends of their common run (PRO); line against facet (`hidden_interval.hpp`)",
      "along the page from event to event, across it from left to right; only what changes is studied",
      "the active list, repaired by exchanges of neighbours; segments by x, depth and slope; crossings in a heap",
      "active list with the facets over every gap; segments; spans; the state of every line that the scan meets",
      "strokes; spans line by line"}},
    {"newell",
     {"faces with holes, as the convex pieces of their triangles in model space (`bsp` says how they are cut); "
      "their extents on the page and in depth. Faces may touch, penetrate, coincide, overlap in rings",
      "by the farthest depth, falling (2.5.2.2)",
      "extents; corners against a plane; projections compared edge by edge; depths over what two projections "
      "have in common; an element cut by a plane (`paint_elements.cpp`)",
      "zones and slabs, nested to the end; then the head of the list against its set Q_P, with marks (2.5.2.4, "
      "`priority_list.cpp`)",
      "pieces of a cut are inserted by their farthest depth",
      "the list: what was moved to its head, the initial sort, the pieces inserted",
      "the order of the pieces (`PaintOrder`); strokes (`StrokeModel`), regions"}},
    {"bsp",
     {"the triangles of the scene's faces, in model space; for the lines `ProjectedScene`. Faces may touch, "
      "penetrate, coincide, overlap in rings",
      "none",
      "height of a corner over a plane; a convex piece cut by a plane (`model_pieces.cpp`); side of a plane on "
      "which the viewer is; line against facet (`hidden_interval.hpp`)",
      "a set of pieces is divided by the plane of one of them, again and again, until no set is left; then the "
      "tree is walked from the viewer away",
      "none: the walk is the sort", "the tree: per node a plane, the pieces in it, a front and a back subtree",
      "the order of the pieces (`PaintOrder`); strokes (`StrokeModel`), regions"}},
    {"convex-tree",
     {"the triangles of the scene's faces, in model space; for the lines `ProjectedScene`. Faces may touch, "
      "penetrate, coincide, overlap in rings",
      "none",
      "height of a point over a plane; is there a point below a plane (`convex_tree.cpp`); a convex piece cut "
      "by a plane (`model_pieces.cpp`); line against facet",
      "the triangles on the convex hull are peeled off; where there are none, a plane separates the set; then "
      "the tree is walked from the viewer away",
      "none: the walk is the sort",
      "the tree: nodes of type 1 (a convex set and what is inside) and of type 2 (a plane and two subtrees)",
      "the order of the pieces (`PaintOrder`); strokes (`StrokeModel`), regions"}},
    {"zbuffer",
     {"`ProjectedScene`: triangles of faces with holes on the page lattice, with depth; candidate lines. Faces "
      "may penetrate, coincide, and be skew. Transparent faces hide nothing and tint areas",
      "triangles by face, faces by bands of 16 rows, sides of a face by their first row; all by counting but "
      "the last",
      "depth against depth at a pixel; a point of a line against four hiding depths",
      "face after face within a band of rows; bands in parallel",
      "the active edges of a face from left to right on every row",
      "table of active edges; the buffer: depth, hiding depth, face",
      "pixels (`PixelModel`); strokes to within two pixels"}},
    {"painter",
     {"`ProjectedScene`: faces with holes on the page lattice, with depth; candidate lines. Opacity is ignored",
      "faces by the mean or the farthest depth of their corners",
      "two facets overlap on the page, and which is in front (`order_of`); a corner against a plane",
      "`mean`, `farthest`: none. `resolved`: what is known of pairs is kept, and among the rest the sort decides",
      "a heap of the faces for which no other has to wait", "pairs of faces that overlap on the page",
      "the order of the faces (`PaintOrder`); strokes, and pixels (`--shade`), both as painting leaves them"}},
    {"culling",
     {"`ProjectedScene`: triangles on the page lattice with depth; one closed, convex, opaque body that is "
      "wholly in view",
      "sides of the triangles by their ends, for the test of the body; none for the drawing",
      "sign of a face's area on the page; depth of a corner against a plane", "every edge by the signs of its two faces",
      "none", "for each face: front, back, or edge on", "strokes, each a whole edge, visible or hidden"}},
    {"roberts",
     {"the model's triangles on the page lattice with depth, as bodies; candidate edges of `ProjectedScene`. "
      "Bodies may touch, penetrate, stand in each other",
      "sides of triangles by their ends, for the bodies; bodies along a Morton curve over the page "
      "[Morton1966], for the tree of their boxes",
      "line against a side of a silhouette; line against a plane; where a line touches or pierces a body, line "
      "against facet (`hidden_interval.hpp`)",
      "every line against the bodies whose boxes its open parts may lie behind",
      "at each branch of the tree, the half over which more of the line lies comes first",
      "bodies: convex silhouette, planes of the front; tree of boxes; open parts of a line",
      "strokes: pieces of lines, visible or hidden as a whole"}},
};

}  // namespace

const SevenParts* seven_parts_of(std::string_view method) {
  const auto found = std::ranges::find(kPartsOfMethods, method, &PartsOfMethod::method);
  return found == std::end(kPartsOfMethods) ? nullptr : &found->parts;
}

}  // namespace ligne
