#include "plotting/svg/outline.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "areas/work_limit_error.hpp"
#include "plotting/readers/drawing_reader.hpp"

namespace ligne::svg {
namespace {

/// Most chords of a curve.
constexpr double kMostPieces = 100'000;

/// Largest turn of an arc over one chord, radians: the chord of an arc that turns by a is shorter by the fraction a^2 /
/// 24.
const double kMostTurn = std::sqrt(24 * kLengthLoss);

/// Angle between two directions; zero if one of them has no length.
double turn_of(Point2 u, Point2 v) { return std::abs(std::atan2(cross(u, v), glm::dot(u, v))); }

/// Number of chords for a curve of this degree. Its second differences are at most `bend` mm, and its control polygon
/// turns by `turn`, which the curve does not exceed. n^2 = degree (degree - 1) / 8 bend / flatness.
int pieces(double degree, double bend, double turn) {
  const double flat = std::sqrt(degree * (degree - 1) / 8 * bend / kFlatnessMm);
  return static_cast<int>(std::clamp(std::ceil(std::max(flat, turn / kMostTurn)), 1.0, kMostPieces));
}

}  // namespace

void Outline::add(Point2 mm) {
  if (!(std::abs(mm.x) <= kFarthestMm && std::abs(mm.y) <= kFarthestMm))
    throw CoordinateRangeError("a point is farther than a kilometre away");
  if (lines_.points.size() >= kMostPoints) throw WorkLimitError("the drawing has more than fifty million points");
  lines_.points.push_back(mm);
}

void Outline::move_to(Point2 p) {
  end();
  at_ = start_ = p;
  first_ = lines_.points.size();
  if (!vertices_) return;
  first_vertex_ = vertices_->size();
  vertices_->push_back({p});
}

void Outline::note(Point2 towards, Point2 coming_from, Point2 end) {
  if (!vertices_) return;
  if (vertices_->empty() || vertices_->back().at != at_) {  // after a closed part
    first_vertex_ = vertices_->size();
    vertices_->push_back({at_});
  }
  vertices_->back().out = towards - at_;
  vertices_->push_back({end, end - coming_from});
}

void Outline::line_to(Point2 p) {
  note(p, at_, p);
  straight_to(p);
}

void Outline::straight_to(Point2 p) {
  if (!open_) add(to_mm_(at_));
  open_ = true;
  add(to_mm_(p));
  at_ = p;
}

void Outline::quadratic_to(Point2 control, Point2 p) {
  const Point2 a = at_, pa = to_mm_(a), pc = to_mm_(control), pb = to_mm_(p);
  note(control != a ? control : p, control != p ? control : a, p);
  const int n = pieces(2, glm::length(pa - 2.0 * pc + pb), turn_of(pc - pa, pb - pc));
  for (int i = 1; i < n; ++i) {
    const double t = static_cast<double>(i) / n, u = 1 - t;
    straight_to(a * (u * u) + control * (2 * u * t) + p * (t * t));
  }
  straight_to(p);
}

void Outline::cubic_to(Point2 control1, Point2 control2, Point2 p) {
  const Point2 a = at_, pa = to_mm_(a), p1 = to_mm_(control1), p2 = to_mm_(control2), pb = to_mm_(p);
  note(control1 != a ? control1 : control2 != a ? control2 : p, control2 != p ? control2 : control1 != p ? control1 : a, p);
  const double bend = std::max(glm::length(pa - 2.0 * p1 + p2), glm::length(p1 - 2.0 * p2 + pb));
  // Where the controls are one point, the turn is from the first leg to the last.
  const double turn = p1 == p2 ? turn_of(p1 - pa, pb - p2) : turn_of(p1 - pa, p2 - p1) + turn_of(p2 - p1, pb - p2);
  const int n = pieces(3, bend, turn);
  for (int i = 1; i < n; ++i) {
    const double t = static_cast<double>(i) / n, u = 1 - t;
    straight_to(a * (u * u * u) + control1 * (3 * u * u * t) + control2 * (3 * u * t * t) + p * (t * t * t));
  }
  straight_to(p);
}

void Outline::arc(Point2 center, double rx, double ry, double rotation, double from, double sweep) {
  const double radius = std::max(rx, ry) * to_mm_.stretch();
  const double step = radius > kFlatnessMm ? std::min(kMostTurn, 2 * std::acos(1 - kFlatnessMm / radius)) : kMostTurn;
  // With a radius far beyond the flatness the step rounds to zero.
  const double wanted = step > 0 ? std::ceil(std::abs(sweep) / step) : kMostPieces;
  const int n = static_cast<int>(std::clamp(wanted, 4.0, kMostPieces));
  const double c = std::cos(rotation), s = std::sin(rotation);
  for (int i = 1; i <= n; ++i) {
    const double angle = from + sweep * i / n, x = rx * std::cos(angle), y = ry * std::sin(angle);
    straight_to({center.x + c * x - s * y, center.y + s * x + c * y});
  }
}

void Outline::arc_to(double rx, double ry, double rotation_degrees, bool large, bool sweep, Point2 p) {
  rx = std::abs(rx);
  ry = std::abs(ry);
  const Point2 a = at_;
  if (rx == 0 || ry == 0 || a == p) {
    if (a != p) line_to(p);
    return;
  }
  const double rotation = rotation_degrees * std::numbers::pi / 180, c = std::cos(rotation), s = std::sin(rotation);
  // The half chord in the frame of the ellipse, on the unit circle.
  const Point2 half = (a - p) * 0.5, middle = (a + p) * 0.5;
  Point2 u{(c * half.x + s * half.y) / rx, (-s * half.x + c * half.y) / ry};
  const double squared = glm::dot(u, u);
  if (!std::isfinite(squared)) throw CoordinateRangeError("an arc is out of the range of numbers");
  if (squared > 1) {  // radii that are too small grow until the arc is half an ellipse
    rx *= std::sqrt(squared);
    ry *= std::sqrt(squared);
    u /= std::sqrt(squared);
  }
  const double away = std::sqrt(std::max(0.0, 1 / glm::dot(u, u) - 1)) * (large == sweep ? -1 : 1);
  const Point2 center_unit{away * u.y, -away * u.x};
  const Point2 from = u - center_unit, to = -u - center_unit;
  double turn = std::atan2(cross(from, to), glm::dot(from, to));
  if (sweep && turn < 0) turn += 2 * std::numbers::pi;
  if (!sweep && turn > 0) turn -= 2 * std::numbers::pi;
  const Point2 center{middle.x + c * rx * center_unit.x - s * ry * center_unit.y,
                      middle.y + s * rx * center_unit.x + c * ry * center_unit.y};
  // The radii overflow: the arc is straight.
  if (!std::isfinite(center.x) || !std::isfinite(center.y) || !std::isfinite(turn)) return line_to(p);
  const auto tangent = [&](Point2 unit) {
    const Point2 along = Point2{-rx * unit.y, ry * unit.x} * (turn < 0 ? -1.0 : 1.0);
    return Point2{c * along.x - s * along.y, s * along.x + c * along.y};
  };
  note(a + tangent(from), p - tangent(to), p);
  arc(center, rx, ry, rotation, std::atan2(from.y, from.x), turn);
  at_ = p;
  lines_.points.back() = to_mm_(p);
}

void Outline::ellipse(Point2 center, double rx, double ry) {
  move_to({center.x + rx, center.y});
  if (vertices_) {
    for (const Point2 end : {Point2{0, ry}, {-rx, 0}, {0, -ry}, {rx, 0}}) arc_to(rx, ry, 0, false, true, center + end);
  } else {
    arc(center, rx, ry, 0, 0, 2 * std::numbers::pi);
  }
  close();
}

void Outline::close() {
  if (open_ && at_ != start_) line_to(start_);
  if (open_) lines_.points.back() = lines_.points[first_];
  end();
  at_ = start_;
  if (!vertices_ || first_vertex_ + 1 >= vertices_->size()) return;
  PathVertex &first = (*vertices_)[first_vertex_], &last = vertices_->back();
  first.in = last.in;
  last.out = first.out;
}

void Outline::end() {
  if (open_) lines_.begin.push_back(static_cast<std::uint32_t>(lines_.points.size()));
  open_ = false;
  first_ = lines_.points.size();
}

namespace {

/// Reads the commands of path data (SVG 1.1, 8.3) into an outline.
class PathData {
 public:
  PathData(Outline& outline, std::string_view data) : outline_(outline), scanner_(data) {}

  std::string read() {
    std::string cause;
    try {
      while (!scanner_.done()) {
        take_command();
        add_part();
        before_ = command_;
      }
    } catch (const CoordinateRangeError&) {
      throw;
    } catch (const WorkLimitError&) {
      throw;
    } catch (const std::invalid_argument& e) {
      cause = e.what();
    }
    outline_.end();
    return cause;
  }

 private:
  void take_command() {
    if (!scanner_.at_number()) {
      command_ = scanner_.take();
      scanner_.skip_blanks();
      if (before_ == '\0' && command_ != 'M' && command_ != 'm')
        throw std::invalid_argument("path data do not begin with M");
    } else if (command_ == 'Z' || command_ == 'z' || command_ == '\0') {
      throw std::invalid_argument("path data have a number where a command should be");
    } else if (before_ == 'M' || before_ == 'm') {
      command_ = command_ == 'M' ? 'L' : command_ == 'm' ? 'l' : command_;
    }
    const bool relative = command_ >= 'a' && command_ <= 'z';
    origin_ = relative ? outline_.at() : Point2{0, 0};
  }

  static char upper(char command) {
    return static_cast<char>(command >= 'a' && command <= 'z' ? command - 'a' + 'A' : command);
  }

  double number() {
    const double v = scanner_.number();
    scanner_.skip_separator();
    return v;
  }
  bool flag() {
    const bool v = scanner_.flag();
    scanner_.skip_separator();
    return v;
  }
  Point2 point() {
    const double x = number();
    return origin_ + Point2{x, number()};
  }

  /// The control point of the last part, mirrored, if that was a curve of this kind; else the current point.
  Point2 smooth_control(char kind, char smooth_kind) const {
    const char last = upper(before_);
    return last == kind || last == smooth_kind ? outline_.at() * 2.0 - control_ : outline_.at();
  }

  void add_part() {
    switch (upper(command_)) {
      case 'M':
        return outline_.move_to(point());
      case 'L':
        return outline_.line_to(point());
      case 'H':
        return outline_.line_to({origin_.x + number(), outline_.at().y});
      case 'V':
        return outline_.line_to({outline_.at().x, origin_.y + number()});
      case 'C':
        return add_cubic(point());
      case 'S':
        return add_cubic(smooth_control('C', 'S'));
      case 'Q':
        return add_quadratic(point());
      case 'T':
        return add_quadratic(smooth_control('Q', 'T'));
      case 'A':
        return add_arc();
      case 'Z':
        return outline_.close();
      default:
        throw std::invalid_argument("path data have an unknown command");
    }
  }

  void add_cubic(Point2 c1) {
    const Point2 c2 = point(), p = point();
    outline_.cubic_to(c1, c2, p);
    control_ = c2;
  }
  void add_quadratic(Point2 c) {
    outline_.quadratic_to(c, point());
    control_ = c;
  }
  void add_arc() {
    const double rx = number(), ry = number(), rotation = number();
    const bool large = flag(), sweep = flag();
    outline_.arc_to(rx, ry, rotation, large, sweep, point());
  }

  Outline& outline_;
  Scanner scanner_;
  char command_ = '\0', before_ = '\0';
  Point2 origin_{0, 0};   ///< relative commands: the point before; else (0, 0)
  Point2 control_{0, 0};  ///< control point of the last curve, for S and T
};

}  // namespace

std::string add_path(Outline& outline, std::string_view data) { return PathData(outline, data).read(); }

}  // namespace ligne::svg
