#pragma once
/// Experiments that repeat those of the sources. docs/study.md gives the results.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "scene/model/scene.hpp"
#include "studies/results/result.hpp"

namespace ligne::studies {

/// `small` is for tests: the tables have fewer rows or smaller scenes and take well under a second.
enum class StudySize : std::uint8_t { small, full };
inline constexpr std::string_view kStudySizeNames[] = {"small", "full"};

struct NamedScene {
  std::string name;
  Scene scene;
  std::string view = "iso";  ///< named view
};

struct StudyRequest {
  StudySize size = StudySize::full;
  std::span<const NamedScene> models{};  ///< scenes from files, added to the generated ones in experiments over scenes

  bool full() const { return size == StudySize::full; }
  template <class T>
  T pick(T small, T large) const {
    return full() ? large : small;
  }
};

struct Experiment {
  std::string_view name;     ///< name on the command line
  std::string_view section;  ///< section of the source
  std::string_view title;    ///< noun phrase
  Result (*run)(const StudyRequest& request);
};

/// All experiments, in the order of the sources.
std::span<const Experiment> experiments();

/// The experiment of that name, or nullptr.
const Experiment* find_experiment(std::string_view name);

// Edges, [Boulle1980] 1.1.
Result study_propagation(const StudyRequest& request);
// Warnock, [Boulle1980] 2.2.
Result study_edge_tests(const StudyRequest& request);
Result study_understanding(const StudyRequest& request);
Result study_windows(const StudyRequest& request);
Result study_window_costs(const StudyRequest& request);
Result study_modules(const StudyRequest& request);
// Scan lines, [Boulle1980] 2.3.
Result study_merge_orders(const StudyRequest& request);
Result study_stack_cost(const StudyRequest& request);
Result study_span_sort(const StudyRequest& request);
Result study_whole_numbers(const StudyRequest& request);
Result study_squares(const StudyRequest& request);
Result study_translation(const StudyRequest& request);
Result study_line_resolution(const StudyRequest& request);
Result study_coherence(const StudyRequest& request);
Result study_planes(const StudyRequest& request);
Result study_line_groups(const StudyRequest& request);
Result study_tracking(const StudyRequest& request);
Result study_remembered(const StudyRequest& request);
Result study_two_tasks(const StudyRequest& request);
// Atherton and Weiler, [Boulle1980] 2.4.
Result study_slab_order(const StudyRequest& request);
Result study_sort_keys(const StudyRequest& request);
Result study_clip_sum(const StudyRequest& request);
Result study_inside_at_once(const StudyRequest& request);
Result study_zone_tests(const StudyRequest& request);
Result study_convex_clip(const StudyRequest& request);
Result study_shadow_cost(const StudyRequest& request);
// Newell, Newell and Sancha, [Boulle1980] 2.5, and the four methods together, 2.6.
Result study_list_cases(const StudyRequest& request);
Result study_decomposition(const StudyRequest& request);
Result study_zones(const StudyRequest& request);
Result study_four_methods(const StudyRequest& request);
// Elementary operations, [Boulle1980] 3.
Result study_segment_tests(const StudyRequest& request);
Result study_many_segments(const StudyRequest& request);
Result study_visible_segments(const StudyRequest& request);
Result study_point_in_contour(const StudyRequest& request);
Result study_segment_clipping(const StudyRequest& request);
Result study_contour_clipping(const StudyRequest& request);
Result study_sorts(const StudyRequest& request);
// The other sources.
Result study_depth_increments(const StudyRequest& request);
Result study_tree_complexity(const StudyRequest& request);
// Successive views, [Boulle1980] conclusion.
Result study_successive_views(const StudyRequest& request);

}  // namespace ligne::studies
