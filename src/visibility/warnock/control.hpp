#pragma once
/// Module of control: decides which windows are studied, and how.
///
/// A window is drawn if it is understood, solved exactly if it has few edges, and otherwise divided. With a limit of
/// resolution no window is solved: at the limit each piece of an edge is visible or hidden as its midpoint is.
///
/// Invariants: the children of a window cover it and share only borders. A piece of a line belongs to one window. Pieces of
/// adjacent windows share the parameter of their common end bitwise, because it depends only on the whole line and the
/// border. Results come in the order of the children, for any number of threads.

#include <algorithm>
#include <array>
#include <functional>

#include "visibility/warnock/areas.hpp"
#include "visibility/warnock/sides.hpp"
#include "visibility/warnock/solution.hpp"
#include "visibility/warnock/understanding.hpp"

namespace ligne::warnock {

enum class SplitChoice : std::uint8_t { centre, vertex, side };

struct Rules {
  SplitChoice split = SplitChoice::centre;
  double limit = 0;  ///< frame units: windows with sides up to this are not divided; 0: no limit, windows are solved exactly
  double margin_steps = 0;  ///< largest distance, in lattice steps, of objects that count as on a border of the window
  double coincidence_steps = 0;
  double precision = 0;       ///< frame units: understanding ignores a strip this wide along the border of a window
  bool find_pairs = false;    ///< searches for penetrating faces
  bool drop_hidden = true;    ///< skips what covers hide
  bool areas = false;         ///< computes visible areas
  bool show_windows = false;  ///< records the cuts
  Knowledge knowledge = Knowledge::all;
  bool remember_sides = true;  ///< children first test the side that made a face an intersector
};

struct Counts {
  std::uint64_t windows = 0;  ///< studied windows
  std::uint64_t divided = 0;
  std::uint64_t empty = 0;  ///< windows with nothing to draw
  std::array<std::uint64_t, kUnderstoodCount> understood{};
  std::uint64_t solved = 0;  ///< solved exactly, because of few edges
  std::uint64_t limit = 0;   ///< windows at the limit of resolution
  AnalysisCounts analysis;
  DepthCounts depth;
  SolutionCounts solution;
  double analysis_seconds = 0, understanding_seconds = 0, solution_seconds = 0,
         area_seconds = 0;  ///< summed over all threads
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

/// The point at which a window is divided.
struct Division {
  double u = 0, v = 0;                ///< strictly inside the window if the flag is set
  bool across = false, down = false;  ///< cut at u, cut at v
};

/// How a rectangle is divided. `split` centre: at the centre. vertex: at the vertex of the nearest intersectors, inside the
/// window, that is nearest to the centre; without one, at the midpoint of an intersecting side. side: along sides of these
/// intersectors that are parallel to the borders, in each direction the one nearest to the centre; without one, as vertex. A
/// window more than four times as long as wide is only cut across.
Division divide(const FaceTable& table, const Lists& lists, const Window& window, const Rules& rules);

/// The part of a piece in each child, with index (u >= cut) + 2 (v >= cut). Calls visit(child, piece) from the piece's start
/// to its end.
template <class Visit>
void cut_piece(const PageLine& line, const Piece& piece, const WindowFrame& frame, const Division& division,
               const Visit& visit) {
  // Along one axis the line changes at the cut from the low to the high side, or the other way round.
  struct Axis {
    double t;            ///< parameter of the crossing with the cut
    bool before, after;  ///< true on the high side
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

/// The part of a piece inside the border (child 0) and outside (child 1); a line along the border is inside. Calls
/// visit(child, piece), from the piece's start to its end. Where the line passes the border is computed from the whole line
/// and the border alone.
template <class Visit>
void cut_piece(const PageLine& line, const Piece& piece, const WindowFrame& frame, const Border& border,
               const Visit& visit) {
  const FramePoint p = frame(line.p0), q = frame(line.p1);
  const int from = border.side(p), to = border.side(q);
  if (from >= 0 && to >= 0) return visit(0, piece);
  if (from <= 0 && to <= 0) return visit(1, piece);
  const double a = std::abs(border.distance(p)), b = std::abs(border.distance(q));
  const double at = a + b > 0 ? a / (a + b) : 0;
  const int before = from > 0 ? 0 : 1;
  if (piece.from < at) visit(before, Piece{piece.line, piece.from, std::min(at, piece.to)});
  if (at < piece.to) visit(1 - before, Piece{piece.line, std::max(at, piece.from), piece.to});
}

class Control {
 public:
  Control(const FaceTable& table, const std::vector<PageLine>& lines, const Rules& rules);

  /// Studies the window with these pieces of lines. `progress`, if set, is called with the studied fraction of the window,
  /// from one thread at a time.
  Outcome study(const Window& window, const std::vector<Piece>& pieces, const std::function<void(double)>& progress) const;

 private:
  struct Task;
  class Progress;

  /// Number of divisions down to a window, and of the latest divisions without shorter lists.
  struct Divisions {
    int depth = 0, stalled = 0;
  };
  /// A part of a divided window.
  struct Child {
    WindowShape window;
    Lists lists;
    std::vector<Piece> pieces;
  };
  void study(const WindowShape& window, const Lists& lists, const std::vector<Piece>& pieces, Divisions divisions,
             Task& task) const;
  void split(const Window& window, const Division& division, const Lists& lists, const std::vector<Piece>& pieces,
             Divisions divisions, Task& task) const;
  /// Divides the window in two, along the border.
  void split(const ConvexWindow& window, const Border& border, const Lists& lists, const std::vector<Piece>& pieces,
             Divisions divisions, Task& task) const;
  /// Studies the parts of a window that `divider` made.
  template <std::size_t kParts, class Shape, class Divider>
  void study_parts(const std::array<Shape, kParts>& windows, const Divider& divider, const Lists& lists,
                   const std::vector<Piece>& pieces, Divisions divisions, Task& task) const;
  /// Studies each child; from kParallelLoad on as tasks. `elements` counts the elements of the divided window, `load` adds
  /// its pieces.
  void study_children(std::span<Child> children, std::size_t elements, std::size_t load, Divisions divisions,
                      Task& task) const;
  void draw(const Window& window, const Lists& lists, const std::vector<Piece>& pieces, Understood understood,
            Task& task) const;
  /// Requires a loaded window.
  void find_pairs(const Window& window, const Lists& lists, Task& task) const;
  void draw_at_limit(const Window& window, const Lists& lists, const std::vector<Piece>& pieces, Task& task) const;
  bool few_edges(const Lists& lists, const std::vector<Piece>& pieces) const;
  /// Width of the strip along the borders that the module of understanding leaves out, frame units.
  double inner_margin(const Window& window) const;

  const FaceTable& table_;
  const std::vector<PageLine>& lines_;
  Rules rules_;
  double margin_;  ///< frame units
  PenetrationSearch no_pairs_;
  Analysis analysis_;
};

}  // namespace ligne::warnock
