#pragma once
/// Cleaning of lines: the rules in their order, with their parameters (docs/linework.md).
///
/// Guarantees, each with a test in tests/linework/guarantees_test.cpp:
/// - Idempotent: lines that were cleaned once stay as they are.
/// - No end of a line moves. Lines are joined and led on by strokes of their own, no longer than the widest gap of a rule.
/// - Nothing goes that is longer than the longest removal of a rule.
/// - Every change is counted by rule, with the length that it adds or removes: the sum is the difference of the drawings.
/// - No free end of a line stays that points at another line within the reach of extend_undershoots, if the line is long
///   enough to be led on.
/// - The order of the strokes, turns by quarters and mirrors do not matter.
/// - The number of threads does not matter.

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "linework/rules/rules.hpp"

namespace ligne {

struct CleanOptions {
  double pen_mm = 0;         ///< width of the pen
  double least_mm = 0;       ///< shorter bits of lines that visibility cuts off are not drawn
  bool has_outlines = true;  ///< without outlines nothing tells that a line passes behind something
  /// Whether all feature classes are drawn. Where a class is left out, lines that would meet its lines stand alone.
  bool has_all_features = true;
  BodyOf scan_of;          ///< numbers the scans; empty: there are none
  BodyOf object_of;        ///< numbers the objects
  MakeSource make_source;  ///< makes the sources of strokes that join lines
};

/// A rule with its parameters.
struct CleaningRule {
  std::string_view name;     ///< the name of its function in rules.hpp
  std::string_view changes;  ///< its changes, for reports
  /// Applies it to the map, and returns the number of changes.
  std::size_t (*apply)(LineMap& map, const CleanOptions& options);
};

/// The rules in the order in which they are applied.
std::span<const CleaningRule> cleaning_rules();

/// The changes of one rule.
struct RuleReport {
  std::string_view name, changes;  ///< see CleaningRule
  std::size_t count = 0;
  double added_mm = 0, removed_mm = 0;  ///< lengths on the page
};

struct CleanReport {
  std::vector<RuleReport> rules;  ///< in the order of cleaning_rules()
  int passes = 0;                 ///< the last one changed nothing, unless it is number kMostCleanPasses
};

/// Passes end, since each bridge lowers the number of free ends, each removal that of pieces, and each merger that of
/// changes of class. Drawings need two to six.
inline constexpr int kMostCleanPasses = 12;

/// Applies the rules to the strokes that are seen, apart from those of class mesh, in passes until a pass changes nothing.
/// No two visible strokes may coincide.
CleanReport clean_lines(StrokeModel& model, const CleanOptions& options);

}  // namespace ligne
