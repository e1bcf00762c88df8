#include "visibility/common/stroke_maker.hpp"

#include <algorithm>
#include <cmath>

namespace ligne {
namespace {

LatticePoint point(const PageLine& line, double t) {
  if (t == 0) return line.p0;
  if (t == 1) return line.p1;
  return {static_cast<std::int32_t>(std::lround(line.p0.x + t * line.dx)),
          static_cast<std::int32_t>(std::lround(line.p0.y + t * line.dy))};
}

Point3 to_model(const ProjectedScene& scene, const ProjectedVertex& v) {
  return to_model_point(scene.view, scene.lattice.to_mm(v.p), v.z);
}

}  // namespace

void StrokeMaker::add(const PageLine& line, const std::vector<LinePart>& parts, std::array<double, 2> range,
                      std::uint32_t source, LineClass line_class, bool may_coincide, std::vector<Stroke>& out) const {
  double end = 0;
  for (const LinePart& part : parts) {
    if (hidden_too_ && part.from > end) {
      out.push_back(stroke(line, {end, part.from}, range, source, line_class, may_coincide, false));
    }
    out.push_back(stroke(line, part, range, source, line_class, may_coincide, true));
    end = part.to;
  }
  if (hidden_too_ && end < 1) out.push_back(stroke(line, {end, 1}, range, source, line_class, may_coincide, false));
}

Stroke StrokeMaker::stroke(const PageLine& line, LinePart part, std::array<double, 2> range, std::uint32_t source,
                           LineClass line_class, bool may_coincide, bool visible) const {
  Stroke s;
  s.from = point(line, part.from);
  s.to = point(line, part.to);
  s.t_from = range[0] + (range[1] - range[0]) * model_parameter(line, part.from);
  s.t_to = range[0] + (range[1] - range[0]) * model_parameter(line, part.to);
  s.z_from = static_cast<float>(line.z(part.from));
  s.z_to = static_cast<float>(line.z(part.to));
  if (scene_.view.camera.perspective) {
    s.w_from = static_cast<float>(1 / scene_.magnification(line.z(part.from)));
    s.w_to = static_cast<float>(1 / scene_.magnification(line.z(part.to)));
  }
  s.source = source;
  s.line_class = line_class;
  s.visible = visible;
  s.level = static_cast<std::uint8_t>(std::min(part.level, 255u));
  s.may_coincide = may_coincide || !visible;  // the search stops when a line is hidden, before it has seen all neighbours
  return s;
}

/// Parameter in model space of the page parameter t: weights are the distances along the sight, one over magnification.
double StrokeMaker::model_parameter(const PageLine& line, double t) const {
  if (!scene_.view.camera.perspective || t == 0 || t == 1) return t;
  const double m0 = scene_.magnification(line.z0), m1 = scene_.magnification(line.z1);
  return t * m1 / ((1 - t) * m0 + t * m1);
}

double page_length(const PageLine& line) { return std::sqrt(line.dx * line.dx + line.dy * line.dy); }

void number_intersections(const ProjectedScene& scene, const std::vector<Intersection>& intersections, StrokeModel& model) {
  std::vector<std::uint32_t> number(intersections.size(), kNone);
  for (Stroke& s : model.strokes) {
    if (s.source < scene.source_count) continue;
    const std::uint32_t i = s.source - scene.source_count;
    if (number[i] == kNone) {
      number[i] = static_cast<std::uint32_t>(model.intersections.size());
      const Intersection& x = intersections[i];
      model.intersections.push_back({{to_model(scene, x.from), to_model(scene, x.to)}, {x.face0, x.face1}, true});
    }
    s.source = scene.source_count + number[i];
  }
}

}  // namespace ligne
