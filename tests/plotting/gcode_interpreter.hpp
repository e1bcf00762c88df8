#pragma once
/// Replays G-code and HPGL as a plotter would, and complains where a plotter would do harm.

#include <string>
#include <string_view>
#include <vector>

#include "geometry/point.hpp"

namespace ligne::test {

struct Replay {
  std::vector<std::vector<Point2>> strokes;  ///< mm for G-code, units for HPGL
  std::vector<std::string> faults;           ///< moves with the pen half down, unknown commands and the like
  std::vector<int> pens;                     ///< selected, in order; G-code: pauses
  Rect reach;                                ///< of all moves, raised ones too
  bool ends_up = false;
};

/// How the pen of a G-code device goes down.
enum class PenKind { servo, servo_reversed, z };

Replay replay_gcode(std::string_view text, PenKind kind);
Replay replay_hpgl(std::string_view text);

}  // namespace ligne::test
