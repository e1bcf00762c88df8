/// 1. An edge of the box is a candidate for its axis if it lies on the convex outline of the picture of the box. One
///    candidate is chosen per axis, so that the axes do not overlap (axis_edges.cpp).
/// 2. Ticks are set at round numbers, as many as leave space for their numbers.
/// 3. Numbers of different axes that would touch are thinned. Names are moved outwards until they touch nothing.

#include "view/axes/axes_layout.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "view/axes/axis_edges.hpp"

namespace ligne {
namespace {

// Lengths in text heights. Adjustable.
constexpr double kTick = 0.7;
constexpr double kGap = 0.5;      ///< from tick to number
constexpr double kNameGap = 0.9;  ///< from numbers to name
constexpr double kBetweenNumbers = 1.2;
constexpr double kBetweenAxes = 0.4;  ///< between texts of different axes, and their ticks
constexpr double kWideName = 4;       ///< wider names are turned along their axis
constexpr double kTitleGap = 1.2;
constexpr double kStepOutwards = 0.5;
constexpr int kMostStepsOutwards = 100;
constexpr double kGridFromEdge = 0.6;  ///< a grid line nearer to an edge of the box would only thicken it
constexpr std::size_t kMostTicks = 11;

/// Smallest sine of the angle between a tick and its axis; otherwise ticks are parallel to the other axes.
constexpr double kFlattestTick = 0.57;

bool holds(const Rect& rect, Point2 p) {
  return p.x >= rect.min.x && p.x <= rect.max.x && p.y >= rect.min.y && p.y <= rect.max.y;
}

/// A tick on the page with its number.
struct PlacedTick {
  Point2 at, direction;
  double reach = 0;  ///< distance from `at` to the centre of the number
  TextItem item;
  TextBox box;
};

class Layout {
 public:
  Layout(const AxesRequest& request, const View& view, const MeasureText& measure)
      : request_(request), view_(view), measure_(measure), box_(request.box()), h_(request.text_height_mm) {}

  AxesPicture make() {
    const AxisEdges edges = choose_axis_edges(box_, view_, h_);
    std::array<std::vector<PlacedTick>, 3> ticks;
    for (unsigned axis = 0; axis < 3; ++axis) {
      if (edges[axis]) ticks[axis] = fitting_ticks(*edges[axis]);
      picture_.has_scale[axis] = !ticks[axis].empty();
    }
    for (unsigned axis = 0; axis < 3; ++axis) {
      for (const PlacedTick& tick : ticks[axis]) {
        picture_.marks.push_back({tick.at, tick.at + tick.direction * (kTick * h_)});
        marks_.push_back({axis, mark_box(picture_.marks.back())});
      }
    }
    for (unsigned axis = 0; axis < 3; ++axis) {
      for (const PlacedTick& tick : ticks[axis]) {
        if (is_free(tick.box, axis)) put(tick.item, tick.box, axis);
      }
    }
    for (unsigned axis = 0; axis < 3; ++axis) {
      if (edges[axis] && !request_.axes[axis].name.empty()) put_name(*edges[axis]);
    }
    add_lines(edges);
    for (const auto& mark : picture_.marks) {
      for (const Point2 p : mark) picture_.extent.extend(p);
    }
    for (const TextBox& box : picture_.boxes) {
      for (const Point2 p : box.corners()) picture_.extent.extend(p);
    }
    return std::move(picture_);
  }

 private:
  struct Placed {
    unsigned axis;
    TextBox box;
  };

  static TextBox mark_box(const std::array<Point2, 2>& mark) {
    const Point2 d = mark[1] - mark[0];
    return {(mark[0] + mark[1]) * 0.5, {glm::length(d) / 2, 0}, -std::atan2(d.y, d.x) * 180 / std::numbers::pi};
  }

  /// Direction of ticks at a point of the axis: that of the other ground axis at this point, or straight outwards.
  Point2 tick_direction(const AxisEdge& edge, const Point3& at) const {
    if (edge.axis == 2) return edge.outward;
    const unsigned other = 1 - edge.axis;
    Point3 across = at;
    across[static_cast<int>(other)] = box_.corner(edge.corner ^ 1u << other)[static_cast<int>(other)];
    const Point2 d = page_point(view_, at) - page_point(view_, across);
    const double length = glm::length(d);
    return length > 0 && glm::dot(d, edge.outward) >= kFlattestTick * length ? d / length : edge.outward;
  }

  Point3 model_point(const AxisEdge& edge, double coordinate) const {
    Point3 p = box_.corner(edge.corner);
    p[static_cast<int>(edge.axis)] = coordinate;
    return p;
  }

  TextBox box_of(const TextItem& item) const { return text_box(item, measure_(item.text, item.height_mm)); }

  std::vector<PlacedTick> placed_ticks(const AxisEdge& edge, const std::vector<Tick>& ticks) const {
    const AxisRequest& axis = request_.axes[edge.axis];
    std::vector<PlacedTick> placed;
    for (const Tick& tick : ticks) {
      const Point3 at = model_point(edge, axis.model_coordinate(tick.at));
      PlacedTick p;
      p.at = page_point(view_, at);
      if (!holds(view_.window, p.at)) continue;
      p.direction = tick_direction(edge, at);
      const double lean = glm::dot(p.direction, edge.outward);
      const TextExtent extent = measure_(tick.label, h_);
      const Point2 half{extent.width / 2, h_ / 2};
      const double support = half.x * std::abs(edge.outward.x) + half.y * std::abs(edge.outward.y);
      p.reach = kTick * h_ + (kGap * h_ + support) / lean;
      p.item = {tick.label, p.at + p.direction * p.reach, h_, TextAcross::center, TextUp::middle, 0};
      p.box = text_box(p.item, extent);
      placed.push_back(std::move(p));
    }
    return placed;
  }

  /// Ticks with numbers, or with names; every n-th name, so that there are at most `most`.
  static std::vector<Tick> ticks_of(const AxisRequest& axis, std::size_t most) {
    if (axis.categories.empty()) return round_ticks(axis.scale, axis.from, axis.to, most);
    std::vector<Tick> ticks;
    const std::size_t every = (axis.categories.size() + most - 1) / most;
    for (std::size_t i = 0; i < axis.categories.size(); i += every) {
      const auto at = static_cast<double>(i);
      if (axis.from <= at && at <= axis.to) ticks.push_back({at, axis.categories[i]});
    }
    return ticks;
  }

  /// The largest number of ticks whose numbers do not touch.
  std::vector<PlacedTick> fitting_ticks(const AxisEdge& edge) {
    const AxisRequest& axis = request_.axes[edge.axis];
    for (std::size_t most = kMostTicks; most > 0;) {
      const std::vector<Tick> ticks = ticks_of(axis, most);
      std::vector<PlacedTick> placed = placed_ticks(edge, ticks);
      bool apart = true;
      for (std::size_t i = 1; i < placed.size() && apart; ++i) {
        apart = !overlap(placed[i - 1].box, placed[i].box, kBetweenNumbers * h_);
      }
      if (apart) {
        for (const Tick& tick : ticks) {
          const double at = axis.model_coordinate(tick.at);
          if (is_off_edges(edge, at)) grid_[edge.axis].push_back(at);
        }
        return placed;
      }
      most = std::min(most, ticks.size()) - 1;
    }
    return {};
  }

  /// Whether the point on the axis is far enough from its ends for a grid line.
  bool is_off_edges(const AxisEdge& edge, double coordinate) const {
    const Point2 p = page_point(view_, model_point(edge, coordinate));
    for (const unsigned corner : {edge.corner, edge.corner | 1u << edge.axis}) {
      if (glm::distance(p, page_point(view_, box_.corner(corner))) < kGridFromEdge * h_) return false;
    }
    return true;
  }

  /// Whether no text, and no tick of another axis, is too near.
  bool is_free(const TextBox& box, unsigned axis) const {
    const auto near = [&](const TextBox& other) { return overlap(box, other, kBetweenAxes * h_); };
    return std::none_of(texts_.begin(), texts_.end(), [&](const Placed& p) { return near(p.box); }) &&
           std::none_of(marks_.begin(), marks_.end(), [&](const Placed& p) { return p.axis != axis && near(p.box); });
  }

  void put(TextItem item, const TextBox& box, unsigned axis) {
    texts_.push_back({axis, box});
    picture_.texts.push_back(std::move(item));
    picture_.boxes.push_back(box);
  }

  /// Angle of a name along an axis, in degrees: readable from below or from the right.
  static double angle_along(const AxisEdge& edge) {
    double angle = -std::atan2(edge.b.y - edge.a.y, edge.b.x - edge.a.x) * 180 / std::numbers::pi;
    // Nearly vertical axes are always read upwards, so that a tiny tilt does not reverse a name.
    constexpr double kUpright = 1;
    if (angle > 90 + kUpright) angle -= 180;
    if (angle <= -90 + kUpright) angle += 180;
    return std::abs(angle - 90) <= kUpright ? 90 : angle;
  }

  void put_name(const AxisEdge& edge) {
    TextItem item{request_.axes[edge.axis].name, {0, 0}, h_, TextAcross::center, TextUp::middle, 0};
    const TextExtent extent = measure_(item.text, h_);
    if (extent.width > kWideName * h_) item.rotation_degrees = angle_along(edge);

    double beyond = (kTick + kGap) * h_;
    for (const Placed& p : texts_) {
      if (p.axis == edge.axis)
        beyond = std::max(beyond, glm::dot(p.box.center - edge.a, edge.outward) + p.box.reach(edge.outward));
    }
    const Point2 middle = (edge.a + edge.b) * 0.5;
    const Point2 direction = tick_direction(edge, to_model_point_on(edge, middle));
    const double lean = glm::dot(direction, edge.outward);
    item.at = middle;
    double reach = beyond + kNameGap * h_ + text_box(item, extent).reach(edge.outward);
    for (int i = 0; i < kMostStepsOutwards; ++i, reach += kStepOutwards * h_) {
      item.at = middle + direction * (reach / lean);
      const TextBox box = text_box(item, extent);
      if (is_free(box, edge.axis)) return put(std::move(item), box, edge.axis);
    }
  }

  /// The point of the edge whose image is nearest to the middle of its visible part; in perspective that is not its
  /// midpoint.
  Point3 to_model_point_on(const AxisEdge& edge, Point2 page) const {
    const HomogeneousPoint a = to_homogeneous(view_, box_.corner(edge.corner));
    const HomogeneousPoint b = to_homogeneous(view_, box_.corner(edge.corner | 1u << edge.axis));
    const Point2 p{a.x / a.w, a.y / a.w}, q{b.x / b.w, b.y / b.w};
    const double s = glm::dot(page - p, q - p) / glm::dot(q - p, q - p);
    const double t = s * a.w / ((1 - s) * b.w + s * a.w);
    const int k = static_cast<int>(edge.axis);
    return model_point(edge, box_.low[k] + t * (box_.high[k] - box_.low[k]));
  }

  void add_lines(const AxisEdges& edges) {
    const BoxSides back = back_sides(box_, view_.camera);
    for (const BoxEdge& edge : box_edges()) {
      bool drawn = is_back(edge, back);
      if (request_.style == AxesStyle::box) drawn = true;
      if (request_.style == AxesStyle::base) {
        drawn = edge.axis == 2 ? edges[2] && edges[2]->corner == edge.from : !(edge.from & 4u);
      }
      if (drawn)
        add_line(is_back(edge, back) ? picture_.lines : picture_.front_lines, box_.corner(edge.from),
                 box_.corner(edge.to()));
    }
    if (request_.style == AxesStyle::grid) add_grid(back);
  }

  void add_grid(const BoxSides& back) {
    for (unsigned axis = 0; axis < 3; ++axis) {
      for (const double at : grid_[axis]) {
        for (unsigned side = 0; side < 3; ++side) {
          if (side == axis) continue;
          const unsigned along = 3 - axis - side;
          for (unsigned end = 0; end < 2; ++end) {
            if (!back[side][end]) continue;
            Point3 a = box_.corner(end << side), b = box_.corner(end << side | 1u << along);
            a[static_cast<int>(axis)] = b[static_cast<int>(axis)] = at;
            add_line(picture_.lines, a, b);
          }
        }
      }
    }
  }

  static void add_line(std::vector<AxisLine>& lines, const Point3& a, const Point3& b) {
    if (a != b) lines.push_back({a, b});
  }

  const AxesRequest& request_;
  const View& view_;
  const MeasureText& measure_;
  AxesBox box_;
  double h_;
  AxesPicture picture_;
  std::array<std::vector<double>, 3> grid_;  ///< model coordinates of grid lines; none for an axis without a scale
  std::vector<Placed> texts_, marks_;
};

}  // namespace

AxesBox AxesRequest::box() const {
  AxesBox box;
  for (int k = 0; k < 3; ++k) {
    box.low[k] = axes[k].model_coordinate(axes[k].from);
    box.high[k] = axes[k].model_coordinate(axes[k].to);
  }
  return box;
}

AxesPicture lay_out_axes(const AxesRequest& request, const View& view, const MeasureText& measure) {
  return Layout(request, view, measure).make();
}

TextItem title_above(const Rect& picture, const std::string& title, double height_mm, double width_mm,
                     const MeasureText& measure) {
  TextItem item{title, {(picture.min.x + picture.max.x) / 2, 0}, height_mm, TextAcross::center, TextUp::base, 0};
  TextExtent extent = measure(title, height_mm);
  if (extent.width > width_mm) {
    item.height_mm *= width_mm / extent.width;
    extent = measure(title, item.height_mm);
  }
  item.at.y = picture.min.y - kTitleGap * item.height_mm - extent.descent;
  return item;
}

}  // namespace ligne
