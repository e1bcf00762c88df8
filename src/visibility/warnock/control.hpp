#pragma once
/// Module of control: which windows are studied, and what becomes of each.
///
/// A window is either understood and drawn; or, when it holds few enough edges, solved exactly; or divided. With a limit of
/// resolution no window is solved: at the limit each piece of an edge is shown or not, as is right for its middle.
///
/// Invariants: the children of a window cover it, and share nothing but borders. A piece of a line belongs to one window;
/// pieces of neighbouring windows share the parameter at which they meet to the last bit, for it is computed from the whole
/// line and the border alone. What is found comes in the order of the children, whatever the threads.

#include <algorithm>
#include <array>
#include <functional>

#include "visibility/warnock/areas.hpp"
#include "visibility/warnock/solution.hpp"
#include "visibility/warnock/understanding.hpp"

namespace ligne::warnock {

enum class SplitChoice : std::uint8_t { centre, vertex, side };

struct Rules {
  SplitChoice split = SplitChoice::centre;
  double limit = 0;  ///< frame units: a window whose sides are no longer is not divided; 0: none, windows are solved exactly
  double margin_steps = 0;  ///< what can lie on a line of the window lies within it
  double coincidence_steps = 0;
  double precision = 0;  ///< frame units: what lies so near to the border of a window does not count when it is understood
  bool find_pairs = false;    ///< penetrating faces are looked for
  bool drop_hidden = true;    ///< what covers hide is not looked at
  bool areas = false;         ///< visible areas are wanted
  bool show_windows = false;  ///< the cuts are kept
  Knowledge knowledge = Knowledge::all;
  bool remember_sides = true;  ///< the side that made a face an intersector is tried first in the children
};

struct Counts {
  std::uint64_t windows = 0;  ///< studied
  std::uint64_t divided = 0;
  std::uint64_t empty = 0;  ///< nothing to draw in them
  std::array<std::uint64_t, kUnderstoodCount> understood{};
  std::uint64_t solved = 0;  ///< exactly, for few edges
  std::uint64_t limit = 0;   ///< at the limit of resolution
  AnalysisCounts analysis;
  DepthCounts depth;
  SolutionCounts solution;
  double analysis_seconds = 0, understanding_seconds = 0, solution_seconds = 0,
         area_seconds = 0;  ///< of all threads together
  void operator+=(const Counts& o);
};

/// A cut of a window by one of its children's borders, or a border of the first window.
struct WindowCut {
  FramePoint from, to;
};

struct Outcome {
  std::vector<FoundPart> parts;
  PenetrationSearch pairs;
  std::vector<AreaPiece> areas;
  std::vector<WindowCut> cuts;
  Counts counts;

  void add(Outcome&& o);
};

/// Where a window is divided.
struct Division {
  double u = 0, v = 0;                ///< strictly inside the window where the flag is set
  bool across = false, down = false;  ///< cut at u, cut at v
};

/// `split` centre: the middle. vertex: of the vertices of the nearest intersectors that lie in the window the one nearest to
/// its centre; where there is none, the middle of an intersecting side. side: along the sides of these intersectors that run
/// as the borders of the window do, and of each direction the nearest to its centre; where there is none, as vertex. A
/// window is not cut across its shorter side when it is more than four times as long.
Division divide(const FaceTable& table, const Lists& lists, const Window& window, const Rules& rules);

/// The part of a piece in each child: index 0..3 = (u >= cut) + 2 (v >= cut). Calls visit(child, piece), from the piece's
/// start to its end.
template <class Visit>
void cut_piece(const PageLine& line, const Piece& piece, const WindowFrame& frame, const Division& division,
               const Visit& visit) {
  // Along one axis the line is on the low side before the cut and on the high side behind it, or the other way round.
  struct Axis {
    double t;            ///< where it passes the cut
    bool before, after;  ///< on the high side
  };
  const auto axis = [](bool cut, double from, double to, double at) {
    if (!cut) return Axis{0, false, false};
    if (from == to) return Axis{0, from >= at, from >= at};
    return Axis{(at - from) / (to - from), from > to, from < to};
  };
  const FramePoint p = frame(line.p0), q = frame(line.p1);
  const Axis u = axis(division.across, p.u, q.u, division.u), v = axis(division.down, p.v, q.v, division.v);
  double t = piece.from;
  while (t < piece.to) {
    const bool high_u = t < u.t ? u.before : u.after, high_v = t < v.t ? v.before : v.after;
    double next = piece.to;
    if (u.t > t) next = std::min(next, u.t);
    if (v.t > t) next = std::min(next, v.t);
    visit((high_u ? 1 : 0) + (high_v ? 2 : 0), {piece.line, t, next});
    t = next;
  }
}

class Control {
 public:
  Control(const FaceTable& table, const std::vector<PageLine>& lines, const Rules& rules);

  /// Studies the window with these pieces of lines. `progress` may be empty; it is called with the studied part of the
  /// window, from one thread at a time.
  Outcome study(const Window& window, const std::vector<Piece>& pieces, const std::function<void(double)>& progress) const;

 private:
  struct Task;
  class Progress;

  /// How often the page was divided for a window, and how many of the last divisions made its lists no shorter.
  struct Divisions {
    int depth = 0, stalled = 0;
  };
  void study(const Window& window, const Lists& lists, const std::vector<Piece>& pieces, Divisions divisions,
             Task& task) const;
  void split(const Window& window, const Division& division, const Lists& lists, const std::vector<Piece>& pieces,
             Divisions divisions, Task& task) const;
  void draw(const Window& window, const Lists& lists, const std::vector<Piece>& pieces, Understood understood,
            Task& task) const;
  /// In a loaded window.
  void find_pairs(const Window& window, const Lists& lists, Task& task) const;
  void draw_at_limit(const Window& window, const Lists& lists, const std::vector<Piece>& pieces, Task& task) const;
  bool few_edges(const Lists& lists, const std::vector<Piece>& pieces) const;
  Window inner(const Window& window) const;

  const FaceTable& table_;
  const std::vector<PageLine>& lines_;
  Rules rules_;
  double margin_;  ///< frame units
  PenetrationSearch no_pairs_;
  Analysis analysis_;
};

}  // namespace ligne::warnock
