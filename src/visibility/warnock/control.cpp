#include "visibility/warnock/control.hpp"

#include <cmath>
#include <mutex>

#include "base/parallel.hpp"
#include "visibility/common/clock.hpp"

namespace ligne::warnock {
namespace {

// Tuned parameters.
constexpr std::size_t kFewFaces = 24;        ///< most faces of a window that is solved
constexpr double kLittleWork = 600;          ///< most tests of a window that is solved
constexpr double kSmallestSteps = 64;        ///< side in lattice steps below which a window is solved
constexpr int kMostStalls = 4;               ///< successive divisions without shorter lists after which a window is solved
constexpr double kStall = 0.7;               ///< a list is shorter if below this part of the parent's
constexpr int kDeepest = 100;                ///< most divisions; divisions at vertices may be uneven
constexpr std::size_t kParallelLoad = 2048;  ///< elements and pieces from which the children become parallel tasks
constexpr double kSlender = 4;               ///< aspect ratio from which a window is cut across only
constexpr std::size_t kTriedElements = 8;    ///< nearest intersectors whose vertices may be cut points
constexpr std::size_t kMostElements = 64;    ///< elements above which a window is divided without trying to understand it
constexpr std::size_t kMostOfExact = 24;     ///< this limit for a study without limit of resolution
constexpr int kProgressDepth = 4;            ///< depth of the windows that report progress

constexpr Window kNoWindow{0, -1, 0, -1};

FramePoint middle_in(FramePoint p, FramePoint q, const Window& w) {
  const auto part =
      clip_parameters<4>({p.u - w.u0, w.u1 - p.u, p.v - w.v0, w.v1 - p.v}, {q.u - w.u0, w.u1 - q.u, q.v - w.v0, w.v1 - q.v});
  const double t = part ? ((*part)[0] + (*part)[1]) / 2 : 0.5;
  return {std::round(p.u + t * (q.u - p.u)), std::round(p.v + t * (q.v - p.v))};
}

bool strictly_inside(const Window& w, FramePoint p) { return w.u0 < p.u && p.u < w.u1 && w.v0 < p.v && p.v < w.v1; }

/// The vertex, or point of a side, nearest to the centre that prevents understanding; the centre if there is none.
FramePoint point_of_failure(const FaceTable& table, const Lists& lists, const Window& w, FramePoint centre) {
  FramePoint best = centre;
  double best_distance = std::numeric_limits<double>::infinity();
  const Element* first = nullptr;
  std::size_t tried = 0;
  for (const Element& e : lists.elements) {
    if (e.relation != Relation::intersector) continue;
    if (!first) first = &e;
    if (++tried > kTriedElements) break;
    for (const Side& s : table.sides_of(table.faces[e.face])) {
      const FramePoint p = table.at(s.v0);
      if (!strictly_inside(w, p)) continue;
      const double distance = std::max(std::abs(p.u - centre.u), std::abs(p.v - centre.v));
      if (distance >= best_distance) continue;
      best_distance = distance;
      best = p;
    }
  }
  if (best_distance < std::numeric_limits<double>::infinity() || !first) return best;
  const auto sides = table.sides_of(table.faces[first->face]);
  const Side& s = sides[std::min<std::size_t>(first->side, sides.size() - 1)];
  return middle_in(table.at(s.v0), table.at(s.v1), w);
}

/// Places of sides of the nearest intersectors that cross the window parallel to its borders: at u, at v.
struct CutsAlongSides {
  double u = kNowhere, v = kNowhere;
  static constexpr double kNowhere = std::numeric_limits<double>::infinity();
};

CutsAlongSides sides_in_the_way(const FaceTable& table, const Lists& lists, const Window& w, FramePoint centre) {
  CutsAlongSides cuts;
  const auto take = [](double& best, double at, double middle) {
    if (std::abs(at - middle) < std::abs(best - middle)) best = at;
  };
  std::size_t tried = 0;
  for (const Element& e : lists.elements) {
    if (e.relation != Relation::intersector) continue;
    if (++tried > kTriedElements) break;
    for (const Side& s : table.sides_of(table.faces[e.face])) {
      const FramePoint p = table.at(s.v0), q = table.at(s.v1);
      const bool meets_v = std::min(p.v, q.v) < w.v1 && w.v0 < std::max(p.v, q.v);
      const bool meets_u = std::min(p.u, q.u) < w.u1 && w.u0 < std::max(p.u, q.u);
      if (p.u == q.u && w.u0 < p.u && p.u < w.u1 && meets_v) take(cuts.u, p.u, centre.u);
      if (p.v == q.v && w.v0 < p.v && p.v < w.v1 && meets_u) take(cuts.v, p.v, centre.v);
    }
  }
  return cuts;
}

}  // namespace

void Counts::operator+=(const Counts& o) {
  windows += o.windows;
  divided += o.divided;
  empty += o.empty;
  for (std::size_t i = 0; i < kUnderstoodCount; ++i) understood[i] += o.understood[i];
  solved += o.solved;
  limit += o.limit;
  analysis += o.analysis;
  depth += o.depth;
  solution += o.solution;
  analysis_seconds += o.analysis_seconds;
  understanding_seconds += o.understanding_seconds;
  solution_seconds += o.solution_seconds;
  area_seconds += o.area_seconds;
}

void Outcome::add(Outcome&& o) {
  parts.insert(parts.end(), o.parts.begin(), o.parts.end());
  pairs.add(std::move(o.pairs));
  areas.insert(areas.end(), o.areas.begin(), o.areas.end());
  cuts.insert(cuts.end(), o.cuts.begin(), o.cuts.end());
  counts += o.counts;
}

Division divide(const FaceTable& table, const Lists& lists, const Window& w, const Rules& rules) {
  const double least = std::max(rules.limit, 1.0);
  Division d{.across = w.width() > least && w.width() * kSlender > w.height(),
             .down = w.height() > least && w.height() * kSlender > w.width()};
  const FramePoint centre{std::floor((w.u0 + w.u1) / 2), std::floor((w.v0 + w.v1) / 2)};
  if (rules.split == SplitChoice::side) {
    const CutsAlongSides cuts = sides_in_the_way(table, lists, w, centre);
    const bool across = cuts.u != CutsAlongSides::kNowhere && w.width() > least;
    const bool down = cuts.v != CutsAlongSides::kNowhere && w.height() > least;
    if (across || down) return {across ? cuts.u : centre.u, down ? cuts.v : centre.v, across, down};
  }
  const FramePoint p = rules.split == SplitChoice::centre ? centre : point_of_failure(table, lists, w, centre);
  d.u = w.u0 < p.u && p.u < w.u1 ? p.u : centre.u;
  d.v = w.v0 < p.v && p.v < w.v1 ? p.v : centre.v;
  return d;
}

/// Working state of one thread.
struct Control::Task {
  Task(const Control& control, Progress& p)
      : progress(p),
        solution(control.table_, control.lines_, control.rules_.coincidence_steps, control.rules_.margin_steps),
        area_search(control.table_, control.lines_),
        outcome{{}, control.no_pairs_.empty_copy(), {}, {}, {}} {}

  Progress& progress;
  Solution solution;
  AreaSearch area_search;
  Outcome outcome;
};

class Control::Progress {
 public:
  explicit Progress(const std::function<void(double)>& report) : report_(report) {}
  void add(double part) {
    if (!report_) return;
    const std::lock_guard lock(mutex_);
    done_ += part;
    report_(std::min(done_, 1.0));
  }

 private:
  const std::function<void(double)>& report_;
  std::mutex mutex_;
  double done_ = 0;
};

Control::Control(const FaceTable& table, const std::vector<PageLine>& lines, const Rules& rules)
    : table_(table),
      lines_(lines),
      rules_(rules),
      margin_(std::ceil(rules.margin_steps * table.frame.unit())),
      no_pairs_(*table.facets, *table.vertices),
      analysis_(table, margin_, rules.drop_hidden, rules.remember_sides) {}

Outcome Control::study(const Window& window, const std::vector<Piece>& pieces,
                       const std::function<void(double)>& report) const {
  Progress progress(report);
  Task task(*this, progress);
  if (window.empty()) return std::move(task.outcome);  // scene without vertices
  Clock clock;
  const Lists lists = analysis_.begin(window, task.outcome.counts.analysis);
  task.outcome.counts.analysis_seconds += clock.lap();
  if (rules_.show_windows) {
    const FramePoint a{window.u0, window.v0}, b{window.u1, window.v0}, c{window.u1, window.v1}, d{window.u0, window.v1};
    task.outcome.cuts = {{a, b}, {b, c}, {c, d}, {d, a}};
  }
  // Areas are trapezoids, put together along borders of rectangles.
  if (rules_.split == SplitChoice::side && !rules_.areas) {
    const ConvexWindow polygon(window);
    study(polygon, lists, pieces, {}, task);
  } else {
    study(window, lists, pieces, {}, task);
  }
  task.outcome.counts.solution += task.solution.counts();
  return std::move(task.outcome);
}

bool Control::few_edges(const Lists& lists, const std::vector<Piece>& pieces) const {
  const auto n = static_cast<double>(lists.elements.size()), m = static_cast<double>(pieces.size());
  if (lists.elements.size() <= kFewFaces) return true;
  return m * n + (rules_.find_pairs || rules_.areas ? n * n / 2 : 0) <= kLittleWork;
}

/// The precision leaves at least a third of the window.
double Control::inner_margin(const Window& window) const {
  const double most = std::floor(std::min(window.width(), window.height()) / 3);
  return std::max(margin_, std::min(rules_.precision, most));
}

void Control::study(const WindowShape& shape, const Lists& lists, const std::vector<Piece>& pieces, Divisions divisions,
                    Task& task) const {
  const int depth = divisions.depth, stalled = divisions.stalled;
  const Window& window = shape.box;
  Counts& counts = task.outcome.counts;
  ++counts.windows;
  const auto report = [&] {
    if (depth <= kProgressDepth) task.progress.add(std::pow(shape.polygon ? 0.5 : 0.25, depth));
  };
  const bool exact = rules_.limit == 0;
  const bool wanted =
      !pieces.empty() || (rules_.find_pairs && lists.elements.size() > 1) || (rules_.areas && !lists.elements.empty());
  if (!wanted) {
    ++counts.empty;
    report();
    return;
  }
  Clock clock;
  const double margin = inner_margin(window);
  const std::optional<ConvexWindow> polygon = shape.polygon ? std::optional(shape.polygon->shrunk(margin)) : std::nullopt;
  const WindowShape inner = polygon ? WindowShape(*polygon) : window.grown(-margin);
  const Situation situation(table_, lists, inner, exact ? kMostOfExact : kMostElements, counts.analysis, counts.depth);
  const Understood understood = understand(situation, rules_.knowledge);
  counts.understanding_seconds += clock.lap();
  if (understood != Understood::no) {
    ++counts.understood[static_cast<std::size_t>(understood)];
    draw(window, lists, pieces, understood, task);
    report();
    return;
  }
  const Division division = shape.polygon ? Division{} : divide(table_, lists, window, rules_);
  const std::optional<Border> border =
      shape.polygon ? dividing_border(table_, lists, *shape.polygon, inner, margin_, rules_.limit) : std::nullopt;
  const bool indivisible = !division.across && !division.down && !border;
  if (exact && (few_edges(lists, pieces) || window.longer_side() < kSmallestSteps * table_.frame.unit() ||
                stalled >= kMostStalls || depth >= kDeepest || indivisible)) {
    ++counts.solved;
    draw(window, lists, pieces, understood, task);
    report();
  } else if (indivisible) {
    ++counts.limit;
    draw_at_limit(window, lists, pieces, task);
    report();
  } else {
    ++counts.divided;
    if (border) {
      split(*shape.polygon, *border, lists, pieces, divisions, task);
    } else {
      split(window, division, lists, pieces, divisions, task);
    }
    if (depth == kProgressDepth) report();
  }
}

void Control::split(const Window& window, const Division& division, const Lists& lists, const std::vector<Piece>& pieces,
                    Divisions divisions, Task& task) const {
  const Window& w = window;
  if (rules_.show_windows) {
    if (division.across) task.outcome.cuts.push_back({{division.u, w.v0}, {division.u, w.v1}});
    if (division.down) task.outcome.cuts.push_back({{w.u0, division.v}, {w.u1, division.v}});
  }
  std::array<Window, 4> windows;
  for (std::size_t k = 0; k < 4; ++k) {
    const bool high_u = k % 2 == 1, high_v = k / 2 == 1;
    windows[k] = (high_u && !division.across) || (high_v && !division.down)
                     ? kNoWindow
                     : Window{high_u ? division.u : w.u0, division.across && !high_u ? division.u : w.u1,
                              high_v ? division.v : w.v0, division.down && !high_v ? division.v : w.v1};
  }
  study_parts(windows, division, lists, pieces, divisions, task);
}

void Control::split(const ConvexWindow& window, const Border& border, const Lists& lists, const std::vector<Piece>& pieces,
                    Divisions divisions, Task& task) const {
  const std::array<ConvexWindow, 2> windows{window.part(border), window.part(border.opposite())};
  if (rules_.show_windows) {
    if (const auto chord = windows[0].edge_along(border)) task.outcome.cuts.push_back({chord->first, chord->second});
  }
  study_parts(windows, border, lists, pieces, divisions, task);
}

template <std::size_t kParts, class Shape, class Divider>
void Control::study_parts(const std::array<Shape, kParts>& windows, const Divider& divider, const Lists& lists,
                          const std::vector<Piece>& pieces, Divisions divisions, Task& task) const {
  std::array<std::vector<Piece>, kParts> parts;
  for (const Piece& piece : pieces) {
    cut_piece(lines_[piece.line], piece, table_.frame, divider,
              [&](int child, const Piece& part) { parts[child].push_back(part); });
  }
  Clock clock;
  std::array<Lists, kParts> child_lists = analysis_.children(lists, windows, task.outcome.counts.analysis);
  task.outcome.counts.analysis_seconds += clock.lap();
  std::vector<Child> children;
  children.reserve(kParts);
  for (std::size_t k = 0; k < kParts; ++k) children.push_back({windows[k], std::move(child_lists[k]), std::move(parts[k])});
  study_children(children, lists.elements.size(), lists.elements.size() + pieces.size(), divisions, task);
}

void Control::study_children(std::span<Child> children, std::size_t elements, std::size_t load, Divisions divisions,
                             Task& task) const {
  const auto study_child = [&](Child& child, Task& own) {
    // Moved here so that they are freed once the window is studied.
    const Lists own_lists = std::move(child.lists);
    std::vector<Piece> own_pieces = std::move(child.pieces);
    // Drops pieces behind the cover: they are hidden.
    std::erase_if(own_pieces, [&](const Piece& p) {
      return lines_[p.line].z(p.from) > own_lists.occluder_depth && lines_[p.line].z(p.to) > own_lists.occluder_depth;
    });
    const bool shorter = static_cast<double>(own_lists.elements.size()) < kStall * static_cast<double>(elements);
    study(child.window, own_lists, own_pieces, {divisions.depth + 1, shorter ? 0 : divisions.stalled + 1}, own);
  };
  if (load < kParallelLoad) {
    for (Child& child : children) {
      if (!child.window.empty()) study_child(child, task);
    }
    return;
  }
  std::vector<Task> tasks;
  tasks.reserve(children.size());
  for (std::size_t k = 0; k < children.size(); ++k) tasks.emplace_back(*this, task.progress);
  parallel_for(children.size(), [&](std::size_t k) {
    if (!children[k].window.empty()) study_child(children[k], tasks[k]);
  });
  for (Task& t : tasks) {
    t.outcome.counts.solution += t.solution.counts();
    task.outcome.add(std::move(t.outcome));
  }
}

void Control::find_pairs(const Window& window, const Lists& lists, Task& task) const {
  constexpr float kNoCover = std::numeric_limits<float>::infinity();
  task.solution.find_pairs(window, rules_.drop_hidden ? lists.occluder_depth : kNoCover, task.outcome.pairs);
  task.outcome.pairs.forget_repeated();
}

void Control::draw(const Window& window, const Lists& lists, const std::vector<Piece>& pieces, Understood understood,
                   Task& task) const {
  Outcome& out = task.outcome;
  Clock clock;
  const bool covered = understood == Understood::surrounder && rules_.drop_hidden;
  const bool pairs = rules_.find_pairs && !covered;
  if (!pieces.empty() || pairs) {
    task.solution.load(lists, window);
    task.solution.draw_lines(pieces, out.parts);
    if (pairs) find_pairs(window, lists, task);
  }
  out.counts.solution_seconds += clock.lap();
  if (!rules_.areas) return;
  if (understood == Understood::surrounder) {
    task.area_search.take_front(lists, window, out.areas);
  } else {
    task.area_search.find(lists, window, pieces, out.areas);
  }
  out.counts.area_seconds += clock.lap();
}

/// Each piece is visible or hidden as its midpoint is.
void Control::draw_at_limit(const Window& window, const Lists& lists, const std::vector<Piece>& pieces, Task& task) const {
  Clock clock;
  task.solution.load(lists, window);
  task.solution.draw_by_middle(pieces, task.outcome.parts);
  if (rules_.find_pairs) {
    find_pairs(window, lists, task);
  }
  task.outcome.counts.solution_seconds += clock.lap();
  if (rules_.areas) task.area_search.take_front(lists, window, task.outcome.areas);
}

}  // namespace ligne::warnock
