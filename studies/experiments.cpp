#include "studies/experiments.hpp"

namespace ligne::studies {
namespace {

constexpr Experiment kExperiments[] = {
    {"propagation", "Boulle 1.1", "the faces before an edge, tested and carried", study_propagation},
    {"edge-tests", "Boulle 2.2.3.1", "remembering the edge that meets a window", study_edge_tests},
    {"understanding", "Boulle 2.2.3.2", "windows by what the module of understanding knows", study_understanding},
    {"windows", "Boulle 2.2.3.3", "windows by the choice of the first one", study_windows},
    {"window-costs", "Boulle 2.2.3.2, 2.2.3.4", "tests of a window against their bounds", study_window_costs},
    {"modules", "Boulle 2.2.3.4", "shares of analysis and understanding; precision", study_modules},
    {"merge-orders", "Boulle 2.3.3.1", "three segments in six orders by merge", study_merge_orders},
    {"stack-cost", "Boulle 2.3.3.2", "the stack's evaluation, term by term", study_stack_cost},
    {"span-sort", "Boulle 2.3.3.2", "what the sort of segments is worth", study_span_sort},
    {"whole-numbers", "Boulle 2.3.3.3", "box, whole numbers, stack, and Warnock against box", study_whole_numbers},
    {"remembered-divisions", "Boulle 2.3.3.3", "divisions of box, remembered from line to line", study_remembered},
    {"squares", "Boulle 2.3.3.4", "n squares at five angles: stack against box by kind of operation", study_squares},
    {"translation", "Boulle 2.3.3.4", "two zones moved along the line", study_translation},
    {"line-resolution", "Boulle 2.3.4.2", "512 lines against 1024", study_line_resolution},
    {"tracking", "Boulle 2.3.4", "strokes from line to line and points of intersections, against exact ones",
     study_tracking},
    {"coherence", "Boulle 2.3.5.3", "lines studied where something changes", study_coherence},
    {"planes", "Boulle 2.3.7", "planes studied against dangling and terminal vertices", study_planes},
    {"line-groups", "Boulle 2.3.6.3", "lines in a group", study_line_groups},
    {"two-tasks", "Boulle 2.3.6.3", "one task prepares the segments, one studies", study_two_tasks},
    {"slab-order", "Boulle 2.4.2.4", "slabs from the far end and from the near end", study_slab_order},
    {"sort-keys", "Boulle 2.4.2.4", "keys of the sort of faces", study_sort_keys},
    {"clip-sum", "Boulle 2.4.2.4", "clips against the sum in n and r", study_clip_sum},
    {"inside-at-once", "Boulle 2.4.2.4", "nearer faces inside a clip face take its place at once, or after all clips",
     study_inside_at_once},
    {"shadow-cost", "Boulle 2.4.2.6", "the cost of cast shadows", study_shadow_cost},
    {"zone-tests", "Boulle 2.4.3.2", "costlier tests of zones: clips spared against their cost", study_zone_tests},
    {"list-cases", "Boulle 2.5.2.7", "extreme cases of the list: apart, cut, rings", study_list_cases},
    {"decomposition", "Boulle 2.5.2.7", "zones and slabs, nested: the tree written out", study_decomposition},
    {"zones", "Boulle 2.6", "lists of zones, sorted one after the other and at the same time", study_zones},
    {"four-methods", "Boulle 2.6", "four methods by nine properties", study_four_methods},
    {"segment-tests", "Boulle 3.2.1.1", "segment against segment, four ways", study_segment_tests},
    {"many-segments", "Boulle 3.2.1.2", "crossings of many segments: sweep against all pairs", study_many_segments},
    {"visible-segments", "Boulle 3.2.1.2", "visible pieces of coplanar segments and arcs, some of them transparent",
     study_visible_segments},
    {"point-in-contour", "Boulle 3.2.2", "point against contour, five ways", study_point_in_contour},
    {"segment-clipping", "Boulle 3.2.3.1", "a segment clipped by codes and by halving", study_segment_clipping},
    {"contour-clipping", "Boulle 3.2.3.2", "contours clipped by contours, three ways", study_contour_clipping},
    {"convex-clip", "Boulle 3.2.3.4", "faces clipped by faces, with convexity kept and without", study_convex_clip},
    {"sorts", "Boulle 3.3", "four sorts on random, sorted and nearly sorted lists", study_sorts},
    {"depth-increments", "Lecture 5.1", "depth by increments against the plane's equation", study_depth_increments},
    {"tree-complexity", "Huet 3.1", "complexity of display trees", study_tree_complexity},
    {"successive-views", "Boulle, conclusion", "views one after the other: what the one before spares",
     study_successive_views},
};

}  // namespace

std::span<const Experiment> experiments() { return kExperiments; }

const Experiment* find_experiment(std::string_view name) {
  for (const Experiment& experiment : kExperiments) {
    if (experiment.name == name) return &experiment;
  }
  return nullptr;
}

}  // namespace ligne::studies
