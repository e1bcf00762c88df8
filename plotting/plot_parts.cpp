#include "plotting/plot_parts.hpp"

#include <functional>
#include <map>
#include <span>

#include <glm/geometric.hpp>

namespace ligne {
namespace {

/// Builds a plot from strokes of another.
class PlotBuilder {
 public:
  explicit PlotBuilder(const Plot& from) : from_(from), plot_{from.page, {}} {}

  /// The pen of the new plot that gets strokes of pen `p`.
  PenLines& lines_of(std::size_t p) {
    if (plot_.pens.empty() || last_ != p) {
      plot_.pens.push_back({from_.pens[p].pen, {}, from_.pens[p].looks});
      last_ = p;
    }
    return plot_.pens.back();
  }
  void add(std::size_t p, std::size_t i, std::span<const Point2> points) {
    PenLines& lines = lines_of(p);
    lines.lines.add(points);
    if (!lines.looks.empty()) lines.look_of.push_back(from_.pens[p].look_of[i]);
  }
  bool empty() const { return plot_.pens.empty(); }
  Plot take() {
    Plot done = std::move(plot_);
    plot_ = {from_.page, {}};
    return done;
  }

 private:
  const Plot& from_;
  Plot plot_;
  std::size_t last_ = 0;
};

/// Calls visit(pen, stroke, points) for all strokes.
void for_each_stroke(const Plot& plot, const std::function<void(std::size_t, std::size_t, std::span<const Point2>)>& visit) {
  for (std::size_t p = 0; p < plot.pens.size(); ++p) {
    for (std::size_t i = 0; i < plot.pens[p].lines.size(); ++i) visit(p, i, plot.pens[p].lines[i]);
  }
}

/// Time of each stroke with the way to it, seconds, as measure() computes it: every pen begins at the home position.
class Clock {
 public:
  Clock(const Plot& plot, const Device& device, Point2 home)
      : plot_(plot), device_(device), pace_(pace_of(device)), home_(home), at_(home) {}

  double seconds(std::size_t p, std::span<const Point2> line) {
    if (line.empty()) return 0;
    double more = 0;
    if (p != pen_) {
      const Pen* const before = pen_ < plot_.pens.size() ? &plot_.pens[pen_].pen : nullptr;
      if (before && before->number != plot_.pens[p].pen.number) more = device_.pen_change_s;
      pen_ = p;
      at_ = home_;
    }
    const double up = glm::distance(at_, line.front());
    at_ = line.back();
    return more + pace_.seconds({1, path_length(line), up});
  }

 private:
  const Plot& plot_;
  const Device& device_;
  PathPace pace_;
  Point2 home_, at_;
  std::size_t pen_ = static_cast<std::size_t>(-1);
};

}  // namespace

std::size_t stroke_count(const Plot& plot) {
  std::size_t strokes = 0;
  for_each_stroke(plot, [&](std::size_t p, std::size_t, std::span<const Point2>) { strokes += !plot.pens[p].pen.skip; });
  return strokes;
}

Plot without_first(const Plot& plot, std::size_t strokes) {
  PlotBuilder rest(plot);
  std::size_t number = 0;
  for_each_stroke(plot, [&](std::size_t p, std::size_t i, std::span<const Point2> line) {
    if (plot.pens[p].pen.skip || number++ >= strokes) rest.add(p, i, line);
  });
  return rest.take();
}

std::size_t strokes_within(const Plot& plot, const Device& device, Point2 home, double seconds) {
  Clock clock(plot, device, home);
  std::size_t done = 0;
  double at = 0;
  for_each_stroke(plot, [&](std::size_t p, std::size_t, std::span<const Point2> line) {
    if (plot.pens[p].pen.skip) return;
    at += clock.seconds(p, line);
    if (at <= seconds) ++done;
  });
  return done;
}

Plot with_actions(const Plot& plot, double every_mm) {
  PlotBuilder whole(plot);
  double left = 0;  // length that the pen can still draw before the next action, mm
  for_each_stroke(plot, [&](std::size_t p, std::size_t i, std::span<const Point2> line) {
    if (plot.pens[p].pen.skip || line.empty()) return whole.add(p, i, line);
    const auto act = [&] {
      PenLines& lines = whole.lines_of(p);
      lines.actions.push_back(static_cast<std::uint32_t>(lines.lines.size()));
      left = every_mm;
    };
    if (std::ranges::binary_search(plot.pens[p].pauses, i)) {
      PenLines& lines = whole.lines_of(p);
      lines.pauses.push_back(static_cast<std::uint32_t>(lines.lines.size()));
    }
    if (!(left > 0)) act();
    std::vector<Point2> piece{line.front()};
    for (std::size_t k = 1; k < line.size(); ++k) {
      const double all = glm::distance(line[k - 1], line[k]);
      double done = 0;
      while (all - done > left) {
        done += left;
        const Point2 cut = line[k - 1] + (line[k] - line[k - 1]) * (done / all);
        piece.push_back(cut);
        whole.add(p, i, piece);
        piece.assign(1, cut);
        act();
      }
      left -= all - done;
      piece.push_back(line[k]);
    }
    whole.add(p, i, piece);
  });
  return whole.take();
}

std::vector<Plot> split_plot(const Plot& plot, const PlotSplit& split, const Device* device, Point2 home) {
  std::vector<Plot> parts;
  PlotBuilder part(plot);
  std::optional<Clock> clock;
  if (device) clock.emplace(plot, *device, home);
  double taken = 0;
  for_each_stroke(plot, [&](std::size_t p, std::size_t i, std::span<const Point2> line) {
    if (plot.pens[p].pen.skip) return part.add(p, i, line);
    const double more = split.by == SplitBy::lifts      ? 1
                        : split.by == SplitBy::distance ? path_length(line)
                                                        : clock->seconds(p, line);
    if (taken > 0 && taken + more > split.most) {
      parts.push_back(part.take());
      taken = 0;
    }
    taken += more;
    part.add(p, i, line);
  });
  if (!part.empty()) parts.push_back(part.take());
  return parts;
}

Plot with_pauses(const std::vector<Plot>& parts) {
  Plot whole;
  for (const Plot& part : parts) {
    whole.page = part.page;
    const std::size_t first = whole.pens.size();
    whole.pens.insert(whole.pens.end(), part.pens.begin(), part.pens.end());
    if (first > 0 && first < whole.pens.size()) whole.pens[first].pauses.insert(whole.pens[first].pauses.begin(), 0);
  }
  return whole;
}

std::vector<std::pair<unsigned, Plot>> plots_of_pens(const Plot& plot) {
  std::map<unsigned, Plot> plots;
  for (const PenLines& pen : plot.pens) {
    Plot& own = plots[pen.pen.number];
    own.page = plot.page;
    own.pens.push_back(pen);
  }
  return {plots.begin(), plots.end()};
}

}  // namespace ligne
