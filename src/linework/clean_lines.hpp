#pragma once
/// Cleaning of lines: the rules in their order, with their parameters (docs/linework.md).
///
/// Guarantees, each with a test in tests/linework/guarantees_test.cpp:
/// - Idempotent: lines that were cleaned once stay as they are.
/// - No end of a line moves. Strokes of their own join and extend lines; they are no longer than the widest gap of a
///   rule.
/// - Nothing longer than the longest removal of a rule is removed.
/// - Every change is counted by rule.
/// - No free end points at another line within the reach of extend_undershoots, if its line is long enough to be
///   extended.
/// - The order of the strokes, turns by quarters and mirrors do not matter.
/// - The number of threads does not matter.

#include <cstddef>
#include <string_view>
#include <vector>

#include "linework/rules/rules.hpp"

namespace ligne {

struct CleanOptions {
  double pen_mm = 0;         ///< width of the pen
  double least_mm = 0;       ///< shorter bits of lines that visibility cuts off are removed
  bool has_outlines = true;  ///< without outlines nothing shows that a line passes behind a face
  /// Whether all feature classes are drawn. If a class is left out, lines that would meet its lines are isolated.
  bool has_all_features = true;
  BodyOf scan_of{};                   ///< numbers the scans; empty: there are none
  BodyOf decimated_of{};              ///< numbers the decimated parts among them, alike; empty: there are none
  BodyOf form_of{};                   ///< numbers the free forms by strokes on edges of their meshes; empty: there are none
  BodyOf object_of{};                 ///< numbers the objects
  IsOutline is_outline{};             ///< knows outlines that are not drawn; empty: none is known
  MakeSource make_source{};           ///< makes the sources of strokes that join lines
  std::vector<double> facet_parts{};  ///< per free form: size of its facets, as a part of its extent
};

/// The changes of one rule.
struct RuleReport {
  std::string_view changes;  ///< what the rule does, in words
  std::size_t count = 0;
};

struct CleanReport {
  std::vector<RuleReport> rules;  ///< in the order in which they are applied; those that the options leave out are missing
  int passes = 0;                 ///< the last one changed nothing unless it is number kMostCleanPasses
};

/// Largest number of passes; drawings need two to six. Passes come to an end: a bridge lowers the number of free ends,
/// a removal the number of pieces, and a merger the number of class changes along lines.
inline constexpr int kMostCleanPasses = 12;

/// Applies the rules to the visible strokes, except those of class mesh, in passes until a pass changes nothing. No two
/// visible strokes may coincide.
CleanReport clean_lines(StrokeModel& model, const CleanOptions& options);

}  // namespace ligne
