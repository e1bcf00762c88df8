#include "box_drawer.hpp"

#include "scene/model/scene_parts.hpp"

namespace ligne::check {

namespace {

constexpr int kPlaces = 20000;     ///< points tried on an edge
constexpr double kThrough = 1e-7;  ///< a sight that is this long inside a box is blocked by it

struct Frame {
  Point3 right, down, forward;
};

Frame frame_of(const Viewer& viewer) {
  const Point3 forward = glm::normalize(viewer.forward);
  const Point3 right = glm::normalize(glm::cross(forward, Point3{0, 0, 1}));
  return {right, glm::cross(forward, right), forward};
}

Rows matrix_of(const Viewer& v) {
  const Frame f = frame_of(v);
  const Point2 middle{105, 148.5};
  const Point3 origin = v.perspective ? v.eye : Point3{0, 0, 0};
  const auto row = [&](const Point3& axis, double factor) {
    return std::array<double, 4>{factor * axis.x, factor * axis.y, factor * axis.z, -factor * glm::dot(axis, origin)};
  };
  const double k = v.perspective ? v.scale * v.distance : v.scale;
  const std::array<double, 4> w = v.perspective ? row(f.forward, 1) : std::array<double, 4>{0, 0, 0, 1};
  Rows rows{row(f.right, k), row(f.down, k), row(f.forward, k), w};
  for (std::size_t i = 0; i < 4; ++i) rows[0][i] += middle.x * w[i], rows[1][i] += middle.y * w[i];
  if (v.perspective) rows[2][3] -= v.scale * v.distance * v.distance;
  return rows;
}

Point3 corner(const Box& box, unsigned v) {
  return {v & 1 ? box.high.x : box.low.x, v & 2 ? box.high.y : box.low.y, v & 4 ? box.high.z : box.low.z};
}

/// Length of the sight from p to the viewer that is inside the box.
double inside(const Box& box, const Point3& p, const Point3& to_viewer, double length) {
  double from = 0, to = length;
  for (int k = 0; k < 3; ++k) {
    double a = (box.low[k] - p[k]) / to_viewer[k], b = (box.high[k] - p[k]) / to_viewer[k];
    if (a > b) std::swap(a, b);
    from = std::max(from, a), to = std::min(to, b);
  }
  return to - from;
}

class Drawer {
 public:
  Drawer(const std::vector<Box>& boxes, const Viewer& viewer) : boxes_(boxes), viewer_(viewer), frame_(frame_of(viewer)) {
    drawing_.model_to_page = matrix_of(viewer);
  }

  DrawingFile draw() {
    for (const Box& box : boxes_)
      for (unsigned v = 0; v < 8; ++v)
        for (unsigned axis = 0; axis < 3; ++axis)
          if (!(v >> axis & 1)) draw_edge(box, v, axis);
    return std::move(drawing_);
  }

 private:
  Point3 to_viewer(const Point3& p) const { return viewer_.perspective ? glm::normalize(viewer_.eye - p) : -frame_.forward; }

  bool visible(const Point3& p) const {
    const double length = viewer_.perspective ? glm::distance(viewer_.eye, p) : std::numeric_limits<double>::infinity();
    return std::none_of(boxes_.begin(), boxes_.end(),
                        [&](const Box& box) { return inside(box, p, to_viewer(p), length) > kThrough; });
  }

  void draw_edge(const Box& box, unsigned v, unsigned axis) {
    const Point3 a = corner(box, v), b = corner(box, v | 1u << axis);
    int looking = 0;  // of the two faces at the edge, how many look at the viewer
    for (unsigned k = 0; k < 3; ++k) {
      if (k == axis) continue;
      Point3 normal{0, 0, 0};
      normal[static_cast<int>(k)] = v >> k & 1 ? 1 : -1;
      looking += glm::dot(normal, to_viewer(a)) > 0;
    }
    const LineKind kind = looking == 1 ? kOutline : kCrease;
    std::optional<int> begin;
    for (int i = 0; i <= kPlaces; ++i) {
      const bool seen = i < kPlaces && visible(a + (b - a) * ((i + 0.5) / kPlaces));
      if (seen && !begin) begin = i;
      if (!seen && begin) {
        add_stroke(a, b, {double(*begin) / kPlaces, double(i) / kPlaces}, kind);
        begin.reset();
      }
    }
  }

  void add_stroke(const Point3& a, const Point3& b, std::array<double, 2> interval, LineKind kind) {
    DrawnStroke stroke;
    stroke.kind = kind;
    stroke.ends = {a, b};
    stroke.interval = interval;
    stroke.edge = static_cast<std::uint32_t>(drawing_.strokes.size());
    for (std::size_t k = 0; k < 2; ++k) stroke.points[k] = page_point(drawing_.model_to_page, a + (b - a) * interval[k]);
    drawing_.strokes.push_back(stroke);
  }

  const std::vector<Box>& boxes_;
  const Viewer& viewer_;
  Frame frame_;
  DrawingFile drawing_;
};

}  // namespace

Scene box_scene(const std::vector<Box>& boxes) {
  Scene scene;
  for (const Box& box : boxes) {
    add_box(scene, box.low, box.high - box.low);
    for (unsigned v = 0; v < 8; ++v) scene.vertices[scene.vertices.size() - 8 + v] = corner(box, v);  // without rounding
  }
  return scene;
}

DrawingFile draw_boxes(const std::vector<Box>& boxes, const Viewer& viewer) { return Drawer(boxes, viewer).draw(); }

Point2 page_point(const Rows& m, const Point3& p) {
  const auto row = [&](std::size_t i) { return m[i][0] * p.x + m[i][1] * p.y + m[i][2] * p.z + m[i][3]; };
  return {row(0) / row(3), row(1) / row(3)};
}

}  // namespace ligne::check
