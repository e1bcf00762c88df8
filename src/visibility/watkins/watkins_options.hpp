#pragma once
/// The options of method watkins.

#include <cstdint>
#include <span>

#include "visibility/method_parameters.hpp"
#include "visibility/watkins/spans/span_method.hpp"

namespace ligne::watkins {

/// How the ends of strokes are found: exactly; or on scan lines (PartEnd in state_tracking.hpp).
enum class Tracking : std::uint8_t { exact, lines, overrun };

struct WatkinsOptions {
  SpanMethodKind kind = SpanMethodKind::stack;
  bool exact = true;        ///< the scan stops at every event; otherwise it goes by lines
  unsigned line_count = 0;  ///< over the height of the page, if not `exact`
  bool whole = false;       ///< whole coordinates
  Tracking tracking = Tracking::exact;
  bool points = false;      ///< intersections as points on scan lines
  bool slopes = false;      ///< skew faces by the slopes of their sides
  std::uint32_t group = 0;  ///< lines of a group; 0: about 32 groups
  std::uint32_t ahead = 0;  ///< lines that a task prepares for the one that studies; 0: one task
};

std::span<const MethodParameter> watkins_parameters();
WatkinsOptions watkins_options(const MethodSettings& settings);

/// Words of the parameter "show".
enum class WatkinsShow : std::uint8_t { spans, plane };

}  // namespace ligne::watkins
