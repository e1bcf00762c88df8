#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

#include "base/no_index.hpp"
#include "geometry/polygons/contour_face.hpp"

// Phases: (1) coincident and opposite edges are dropped; (2) loops are traced: at a corner with several ways on, the
// loop follows the sector of the inside that it came along, so that parts that share only a corner are separated; (3)
// loops that return to a corner are cut there; (4) holes are given to the outer contours that hold them.

namespace ligne {
namespace {

struct Run {
  FinePoint begin, end;
  std::uint32_t edge;
};

bool same_place(const Run& a, const Run& b) { return a.begin == b.begin && a.end == b.end; }

struct Box {
  FinePoint low{std::numeric_limits<std::int64_t>::max(), std::numeric_limits<std::int64_t>::max()};
  FinePoint high{std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::min()};

  void extend(FinePoint p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  bool holds(const Box& o) const { return low.x <= o.low.x && low.y <= o.low.y && o.high.x <= high.x && o.high.y <= high.y; }
};

/// A closed contour of runs with its corners, and twice its signed area.
struct Loop {
  EdgeLoop edges;
  std::vector<FinePoint> corners;
  double area = 0;
  Box box;
};

class Linker {
 public:
  Linker(std::vector<ContourEdge> edges, bool closed) : edges_(std::move(edges)), closed_(closed) {}

  std::vector<ContourFace> link() {
    if (closed_) gather_short_runs();
    gather_runs();
    find_corners();
    for (std::uint32_t i = 0; i < runs_.size(); ++i) {
      if (!used_[i]) trace(i);
    }
    return make_faces();
  }

 private:
  void gather_runs();
  void gather_short_runs();
  void insert_short_runs(EdgeLoop& loop);
  void find_corners();
  void trace(std::uint32_t first);
  std::uint32_t next(std::uint32_t run) const;
  void add_loop(std::span<const std::uint32_t> runs);
  std::vector<ContourFace> make_faces();
  /// Whether several runs begin where this one does. Such a corner is kept even if the contour goes straight on: once
  /// rounded, it may lie beside the longer edge, and contours that touch there would cross.
  bool shared_corner(std::uint32_t run) const {
    return (run > 0 && runs_[run - 1].begin == runs_[run].begin) ||
           (run + 1 < runs_.size() && runs_[run + 1].begin == runs_[run].begin);
  }
  const ContourEdge& edge(std::uint32_t run) const { return edges_[runs_[run].edge]; }

  std::vector<ContourEdge> edges_;
  bool closed_;
  std::vector<Run> short_runs_;        ///< runs that end where they begin, by place; only if they are to be kept
  std::vector<Run> runs_;              ///< by begin
  std::vector<std::uint32_t> corner_;  ///< per run: the first run that begins at its end, which is the corner's number
  std::vector<std::uint8_t> used_;
  std::vector<std::uint32_t> place_;  ///< per corner: its index on the current path
  std::vector<std::uint32_t> path_;
  std::vector<Loop> outer_, holes_;
};

/// Gathers short runs: keeps one of two coincident runs, and none if they run in opposite directions.
void Linker::gather_short_runs() {
  for (std::uint32_t i = 0; i < edges_.size(); ++i) {
    const FinePoint p = edges_[i].begin();
    if (p != edges_[i].end() || compare(edges_[i].from, edges_[i].to) == 0) continue;
    const auto same = std::find_if(short_runs_.begin(), short_runs_.end(), [&](const Run& r) {
      const ContourEdge &a = edges_[r.edge], &b = edges_[i];
      return r.begin == p && a.segment == b.segment && compare(a.from, b.from) == 0 && compare(a.to, b.to) == 0;
    });
    if (same == short_runs_.end()) {
      short_runs_.push_back({p, p, i});
    } else if (edges_[same->edge].reversed != edges_[i].reversed) {
      short_runs_.erase(same);
    }
  }
  std::stable_sort(short_runs_.begin(), short_runs_.end(), [](const Run& a, const Run& b) { return a.begin < b.begin; });
}

/// Inserts the short runs that lie at corners of the loop.
void Linker::insert_short_runs(EdgeLoop& loop) {
  EdgeLoop all;
  for (const ContourEdge& e : loop) {
    const FinePoint p = e.begin();
    const auto first = std::lower_bound(short_runs_.begin(), short_runs_.end(), p,
                                        [](const Run& r, const FinePoint& q) { return r.begin < q; });
    auto last = first;
    for (; last != short_runs_.end() && last->begin == p; ++last) all.push_back(edges_[last->edge]);
    short_runs_.erase(first, last);
    all.push_back(e);
  }
  loop = std::move(all);
}

void Linker::gather_runs() {
  runs_.reserve(edges_.size());
  for (std::uint32_t i = 0; i < edges_.size(); ++i) {
    const Run run{edges_[i].begin(), edges_[i].end(), i};
    if (run.begin != run.end) runs_.push_back(run);
  }
  std::sort(runs_.begin(), runs_.end(), [&](const Run& a, const Run& b) {
    if (a.begin != b.begin) return a.begin < b.begin;
    if (a.end != b.end) return a.end < b.end;
    if (closed_) return a.edge < b.edge;
    return std::pair(edges_[a.edge].source, a.edge) < std::pair(edges_[b.edge].source, b.edge);
  });
  runs_.erase(std::unique(runs_.begin(), runs_.end(), same_place), runs_.end());
  std::vector<Run> kept;
  kept.reserve(runs_.size());
  for (const Run& run : runs_) {
    const Run back{run.end, run.begin, 0};
    const auto found = std::lower_bound(runs_.begin(), runs_.end(), back, [](const Run& a, const Run& b) {
      return std::pair(a.begin, a.end) < std::pair(b.begin, b.end);
    });
    if (found == runs_.end() || !same_place(*found, back)) kept.push_back(run);
  }
  runs_ = std::move(kept);
}

void Linker::find_corners() {
  corner_.resize(runs_.size());
  used_.assign(runs_.size(), 0);
  place_.assign(runs_.size(), kNone);
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    const auto found = std::lower_bound(runs_.begin(), runs_.end(), runs_[i].end,
                                        [](const Run& r, const FinePoint& p) { return r.begin < p; });
    corner_[i] =
        found != runs_.end() && found->begin == runs_[i].end ? static_cast<std::uint32_t>(found - runs_.begin()) : kNone;
  }
}

/// Whether `a` is met before `b` when turning negatively from the direction back along the run.
bool met_before(const ContourEdge& came, const ContourEdge& a, const ContourEdge& b) {
  const double rx = -came.dx(), ry = -came.dy();
  const auto quarter = [&](const ContourEdge& e) {  // 0: less than half a turn, 1: half a turn, 2: more, 3: a whole one
    const double turn = rx * e.dy() - ry * e.dx();
    if (turn != 0) return turn < 0 ? 0 : 2;
    return rx * e.dx() + ry * e.dy() < 0 ? 1 : 3;
  };
  const int qa = quarter(a), qb = quarter(b);
  if (qa != qb) return qa < qb;
  return a.dx() * b.dy() - a.dy() * b.dx() < 0;
}

std::uint32_t Linker::next(std::uint32_t run) const {
  std::uint32_t best = kNone;
  if (corner_[run] == kNone) return best;
  for (std::uint32_t k = corner_[run]; k < runs_.size() && runs_[k].begin == runs_[run].end; ++k) {
    if (used_[k]) continue;
    if (best == kNone || met_before(edge(run), edge(k), edge(best))) best = k;
  }
  return best;
}

void Linker::trace(std::uint32_t first) {
  path_.clear();
  // The corner at which a run begins, which is the end corner of the run before it.
  const auto begin_corner = [&](std::uint32_t run) {
    const auto found = std::lower_bound(runs_.begin(), runs_.end(), runs_[run].begin,
                                        [](const Run& r, const FinePoint& p) { return r.begin < p; });
    return static_cast<std::uint32_t>(found - runs_.begin());
  };
  std::uint32_t corner = begin_corner(first);
  for (std::uint32_t run = first; run != kNone; run = next(run)) {
    used_[run] = 1;
    place_[corner] = static_cast<std::uint32_t>(path_.size());
    path_.push_back(run);
    corner = corner_[run];
    if (corner == kNone) break;
    if (place_[corner] == kNone) continue;
    // Back at a corner of the path: the path since then is a loop.
    const std::size_t from = place_[corner];
    add_loop(std::span(path_).subspan(from));
    for (std::size_t k = from; k < path_.size(); ++k) place_[begin_corner(path_[k])] = kNone;
    path_.resize(from);
    if (path_.empty()) return;
  }
  for (const std::uint32_t run : path_) place_[begin_corner(run)] = kNone;
}

bool continues(const ContourEdge& a, const ContourEdge& b) {
  return a.source == b.source && a.segment == b.segment && a.reversed == b.reversed &&
         (a.reversed ? compare(a.from, b.to) == 0 : compare(a.to, b.from) == 0);
}

void extend(ContourEdge& a, const ContourEdge& b) {
  if (a.reversed) {
    a.from = b.from;
  } else {
    a.to = b.to;
  }
}

void Linker::add_loop(std::span<const std::uint32_t> runs) {
  Loop loop;
  loop.edges.reserve(runs.size());
  for (const std::uint32_t run : runs) {
    if (!loop.edges.empty() && !shared_corner(run) && continues(loop.edges.back(), edge(run))) {
      extend(loop.edges.back(), edge(run));
    } else {
      loop.edges.push_back(edge(run));
      loop.corners.push_back(runs_[run].begin);
    }
  }
  if (loop.edges.size() > 1 && !shared_corner(runs.front()) && continues(loop.edges.back(), loop.edges.front())) {
    extend(loop.edges.back(), loop.edges.front());
    loop.edges.erase(loop.edges.begin());
    loop.corners.erase(loop.corners.begin());
  }
  for (const FinePoint p : loop.corners) loop.box.extend(p);
  loop.area = twice_area(loop.edges);
  if (!short_runs_.empty() && loop.area != 0) insert_short_runs(loop.edges);
  if (loop.area > 0)
    outer_.push_back(std::move(loop));
  else if (loop.area < 0)
    holes_.push_back(std::move(loop));
}

/// +1 inside, 0 on the contour, -1 outside; `p` is in half parts.
int position(const Loop& loop, FinePoint p) {
  int winding = 0;
  for (std::size_t i = 0, n = loop.corners.size(); i < n; ++i) {
    const FinePoint c = loop.corners[i], d = loop.corners[i + 1 == n ? 0 : i + 1];
    const FinePoint a{2 * c.x, 2 * c.y}, b{2 * d.x, 2 * d.y};
    const Int128 turn = Int128{b.x - a.x} * (p.y - a.y) - Int128{b.y - a.y} * (p.x - a.x);
    if (turn == 0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
        p.y <= std::max(a.y, b.y)) {
      return 0;
    }
    if (a.y <= p.y && p.y < b.y && turn > 0) ++winding;
    if (b.y <= p.y && p.y < a.y && turn < 0) --winding;
  }
  return winding > 0 ? 1 : -1;
}

/// A hole lies in an outer contour if one of its corners does. If all corners lie on the contour, the middle of an edge
/// decides.
bool holds(const Loop& outer, const Loop& hole) {
  if (!outer.box.holds(hole.box)) return false;
  for (const FinePoint p : hole.corners) {
    if (const int at = position(outer, {2 * p.x, 2 * p.y}); at != 0) return at > 0;
  }
  for (std::size_t i = 0, n = hole.corners.size(); i < n; ++i) {
    const FinePoint p = hole.corners[i], q = hole.corners[i + 1 == n ? 0 : i + 1];
    if (const int at = position(outer, {p.x + q.x, p.y + q.y}); at != 0) return at > 0;
  }
  return true;
}

std::vector<ContourFace> Linker::make_faces() {
  std::vector<ContourFace> faces(outer_.size());
  if (!holes_.empty()) {
    std::vector<std::uint32_t> by_area(outer_.size());
    for (std::uint32_t i = 0; i < by_area.size(); ++i) by_area[i] = i;
    std::sort(by_area.begin(), by_area.end(),
              [&](std::uint32_t a, std::uint32_t b) { return std::pair(outer_[a].area, a) < std::pair(outer_[b].area, b); });
    std::vector<std::vector<EdgeLoop>> holes_of(outer_.size());
    for (Loop& hole : holes_) {
      for (const std::uint32_t i : by_area) {
        if (outer_[i].area < -hole.area || !holds(outer_[i], hole)) continue;
        holes_of[i].push_back(std::move(hole.edges));
        break;
      }
    }
    for (std::size_t i = 0; i < faces.size(); ++i) faces[i].contours = std::move(holes_of[i]);
  }
  for (std::size_t i = 0; i < faces.size(); ++i)
    faces[i].contours.insert(faces[i].contours.begin(), std::move(outer_[i].edges));
  return faces;
}

}  // namespace

std::vector<ContourFace> link_edges(std::vector<ContourEdge> edges, bool closed) {
  return Linker(std::move(edges), closed).link();
}

}  // namespace ligne
