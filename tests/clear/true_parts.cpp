#include "clear/true_parts.hpp"

#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"
#include "support/scene_parts.hpp"

namespace ligne::test {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
/// Radii and lengths below are none.
constexpr double kNothing = 1e-9;

Point2 left_of(Point2 d) { return {-d.y, d.x}; }
double turn_of(Point2 a, Point2 b) { return a.x * b.y - a.y * b.x; }

// ---- Profiles ----

/// A corner of a polygon that becomes an arc of this radius.
struct Corner {
  Point2 at;
  double radius = 0;
};

Profile rounded(const std::vector<Corner>& corners) {
  Profile profile;
  Point2 last(0, 0);
  const auto add = [&](const ProfilePiece& piece) {
    if (piece.sweep != 0 || profile.empty() || glm::distance(piece.end, last) > kNothing) profile.push_back(piece);
    last = piece.end;
  };
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto& [at, radius] = corners[i];
    const Point2 in = glm::normalize(at - corners[(i + corners.size() - 1) % corners.size()].at);
    const Point2 out = glm::normalize(corners[(i + 1) % corners.size()].at - at);
    const double sweep = std::atan2(turn_of(in, out), glm::dot(in, out)), cut = radius * std::tan(std::abs(sweep) / 2);
    add({at - cut * in, {0, 0}, 0});
    if (radius == 0) continue;
    const Point2 centre = last + (sweep > 0 ? radius : -radius) * left_of(in);
    add({at + cut * out, centre, sweep});
  }
  // The first line may be of no length, from the end of the last arc.
  if (profile.size() > 1 && profile[0].sweep == 0 && glm::distance(profile[0].end, last) <= kNothing)
    profile.erase(profile.begin());
  return profile;
}

Profile rectangle(Point2 low, Point2 high, double radius) {
  return rounded({{low, radius}, {{high.x, low.y}, radius}, {high, radius}, {{low.x, high.y}, radius}});
}

Profile hole(Profile way) {
  Profile back;
  for (std::size_t i = way.size(); i-- > 0;)
    back.push_back({way[(i + way.size() - 1) % way.size()].end, way[i].centre, -way[i].sweep});
  return back;
}

Profile circle(Point2 centre, double radius) { return rectangle(centre - Point2(radius), centre + Point2(radius), radius); }

Point2 begin_of(const Profile& profile, std::size_t i) { return profile[(i + profile.size() - 1) % profile.size()].end; }

double radius_of(const Profile& profile, std::size_t i) {
  return profile[i].sweep == 0 ? 0 : glm::distance(profile[i].centre, profile[i].end);
}

/// The point of a piece at t in [0, 1], and the direction there.
Point2 point_at(const Profile& profile, std::size_t i, double t) {
  const ProfilePiece& piece = profile[i];
  const Point2 from = begin_of(profile, i);
  if (piece.sweep == 0) return from + t * (piece.end - from);
  const Point2 arm = from - piece.centre;
  return piece.centre + std::cos(t * piece.sweep) * arm + std::sin(t * piece.sweep) * left_of(arm);
}

Point2 direction_at(const Profile& profile, std::size_t i, double t) {
  const ProfilePiece& piece = profile[i];
  if (piece.sweep == 0) return glm::normalize(piece.end - begin_of(profile, i));
  const Point2 arm = glm::normalize(point_at(profile, i, t) - piece.centre);
  return piece.sweep > 0 ? left_of(arm) : -left_of(arm);
}

/// The normal of the surface over a piece, outwards.
Point2 normal_at(const Profile& profile, std::size_t i, double t) { return -left_of(direction_at(profile, i, t)); }

/// The corners of a profile, arcs by so many facets to a turn.
std::vector<Point2> corners_of(const Profile& profile, int facets) {
  std::vector<Point2> corners;
  for (std::size_t i = 0; i < profile.size(); ++i) {
    const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(profile[i].sweep) / kTurn * facets - 1e-6)));
    for (int k = 0; k < steps; ++k) corners.push_back(point_at(profile, i, double(k) / steps));
  }
  return corners;
}

/// How two pieces meet at the end of the first one.
std::optional<TrueLine> joint(const Profile& profile, std::size_t i) {
  const std::size_t next = (i + 1) % profile.size();
  const Point2 in = direction_at(profile, i, 1), out = direction_at(profile, next, 0);
  const double turn = std::atan2(std::abs(turn_of(in, out)), glm::dot(in, out));
  if (turn >= kTurn / 36) return TrueLine::sharp;
  const auto bend = [&](std::size_t k) {
    return profile[k].sweep == 0 ? 0 : std::copysign(1 / radius_of(profile, k), profile[k].sweep);
  };
  if (std::abs(bend(i) - bend(next)) <= kNothing) return std::nullopt;
  return TrueLine::tangent;
}

// ---- Meshes ----

using MeshTriangles = std::vector<std::array<Point3, 3>>;

MeshTriangles mesh_of(const Extrusion& part, int facets) {
  Scene scene;
  std::vector<std::vector<std::uint32_t>> bottom, top;
  for (const Profile& profile : part.profiles) {
    const std::vector<Point2> corners = corners_of(profile, facets);
    std::vector<std::uint32_t>&low = bottom.emplace_back(), &high = top.emplace_back();
    for (const Point2 p : corners) {
      low.push_back(static_cast<std::uint32_t>(scene.vertices.size()));
      high.push_back(low.back() + 1);
      scene.vertices.emplace_back(p.x, p.y, 0);
      scene.vertices.emplace_back(p.x, p.y, part.height);
    }
    for (std::size_t i = 0; i < low.size(); ++i) {
      const std::size_t j = (i + 1) % low.size();
      scene.faces.add_face(std::array{low[i], low[j], high[j], high[i]});
    }
    std::reverse(low.begin(), low.end());
  }
  for (const auto& contours : {bottom, top}) {
    scene.faces.add_face(contours[0]);
    for (std::size_t i = 1; i < contours.size(); ++i) scene.faces.add_hole(contours[i]);
  }
  scene.objects.push_back({});
  scene.objects.back().vertex_end = static_cast<std::uint32_t>(scene.vertices.size());
  scene.objects.back().face_end = static_cast<std::uint32_t>(scene.faces.size());
  finish(scene);
  MeshTriangles triangles;
  for (const Triangle& t : build_topology(scene).triangles)
    triangles.push_back({scene.vertices[t.v[0]], scene.vertices[t.v[1]], scene.vertices[t.v[2]]});
  return triangles;
}

Point3 turned(Point2 p, double angle) { return {p.x * std::cos(angle), p.x * std::sin(angle), p.y}; }

MeshTriangles mesh_of(const Turning& part, int facets) {
  MeshTriangles triangles;
  const std::vector<Point2> corners = corners_of(part.profile, facets);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point2 from = corners[i], to = corners[(i + 1) % corners.size()];
    for (int k = 0; k < facets; ++k) {
      const double a = kTurn * k / facets, b = kTurn * ((k + 1) % facets) / facets;
      if (from.x > kNothing) triangles.push_back({turned(from, a), turned(from, b), turned(to, to.x > kNothing ? b : 0)});
      if (to.x > kNothing) triangles.push_back({turned(from, from.x > kNothing ? a : 0), turned(to, b), turned(to, a)});
    }
  }
  return triangles;
}

// ---- True lines ----

class Lines {
 public:
  Lines(const Viewer& viewer, double step) : viewer_(viewer), step_(step) {}

  std::vector<TruePoint> of(const Extrusion& part) {
    for (const Profile& profile : part.profiles) {
      const auto wall = [&](std::size_t i, double t) { return Point3(normal_at(profile, i, t), 0); };
      for (std::size_t i = 0; i < profile.size(); ++i) {
        for (const double z : {0.0, part.height}) {
          const Point3 side(0, 0, z > 0 ? 1 : -1);
          add(
              TrueLine::sharp, radius_of(profile, i), [&](double t) { return Point3(point_at(profile, i, t), z); },
              [&](double t) {
                return std::array{side, wall(i, t)};
              });
        }
        const auto upright = [&](TrueLine kind, Point2 p, double radius) {
          const std::array<Point3, 2> normals{wall(i, 1), wall((i + 1) % profile.size(), 0)};
          add(
              kind, radius, [&](double t) { return Point3(p, t * part.height); }, [&](double) { return normals; });
        };
        if (const auto kind = joint(profile, i)) upright(*kind, profile[i].end, 0);
        if (profile[i].sweep == 0) continue;
        for (const double t : turning_points(profile, i))
          upright(TrueLine::outline, point_at(profile, i, t), radius_of(profile, i));
      }
    }
    return std::move(points_);
  }

  std::vector<TruePoint> of(const Turning& part) {
    const Profile& profile = part.profile;
    for (std::size_t i = 0; i < profile.size(); ++i) {
      const Point2 end = profile[i].end, in = normal_at(profile, i, 1),
                   out = normal_at(profile, (i + 1) % profile.size(), 0);
      if (const auto kind = joint(profile, i); kind && end.x > kNothing) {
        add(
            *kind, end.x, [&](double t) { return turned(end, kTurn * t); },
            [&](double t) {
              return std::array{turned(in, kTurn * t), turned(out, kTurn * t)};
            });
      }
      add_outlines(profile, i);
    }
    return std::move(points_);
  }

 private:
  /// Adds samples of a curve at(t), t in [0, 1], between surfaces with the normals normals(t).
  template <class At, class Normals>
  void add(TrueLine kind, double radius, const At& at, const Normals& normals) {
    double length = 0;
    constexpr int kMeasured = 64;
    for (int k = 0; k < kMeasured; ++k) length += glm::distance(at(double(k) / kMeasured), at(double(k + 1) / kMeasured));
    const int steps = std::max(1, static_cast<int>(std::ceil(length / step_)));
    for (int k = 0; k < steps; ++k) {
      const Point3 from = at(double(k) / steps), to = at(double(k + 1) / steps);
      points_.push_back({kind, 0.5 * (from + to), to - from, radius, false, normals((k + 0.5) / steps)});
    }
  }

  /// Where the wall over an arc turns away from the viewer.
  std::vector<double> turning_points(const Profile& profile, std::size_t i) const {
    std::vector<double> found;
    constexpr int kSteps = 256;
    const auto facing = [&](double t) {
      const Point2 d = direction_at(profile, i, t),
                   way = Point2(viewer_.at) - (viewer_.is_eye ? point_at(profile, i, t) : Point2(0));
      return d.y * way.x - d.x * way.y;
    };
    for (int k = 0; k < kSteps; ++k) {
      double low = double(k) / kSteps, high = double(k + 1) / kSteps;
      if ((facing(low) > 0) == (facing(high) > 0)) continue;
      for (int halving = 0; halving < 40; ++halving) {
        const double middle = (low + high) / 2;
        ((facing(middle) > 0) == (facing(low) > 0) ? low : high) = middle;
      }
      found.push_back(low);
    }
    return found;
  }

  /// The two outlines of the surface that a piece of a profile turns into.
  void add_outlines(const Profile& profile, std::size_t i) {
    const Point3& to = viewer_.at;
    const double across = std::hypot(to.x, to.y), towards = std::atan2(to.y, to.x);
    // Cosine of the angle between the outline and the direction towards the viewer, about z. The normal is (d.y, -d.x) in
    // r and z, and at a right angle to the line of sight.
    const auto cosine = [&](double t) {
      const Point2 d = direction_at(profile, i, t), p = viewer_.is_eye ? point_at(profile, i, t) : Point2(0);
      return (d.y * p.x + d.x * (to.z - p.y)) / (d.y * across);
    };
    const auto has_outline = [&](double t) { return std::abs(cosine(t)) <= 1 && point_at(profile, i, t).x > kNothing; };
    constexpr int kSteps = 4000;
    for (const double side : {-1.0, 1.0}) {
      std::vector<Point3> line;
      const auto add_at = [&](double t) {
        line.push_back(turned(point_at(profile, i, t), towards + side * std::acos(std::clamp(cosine(t), -1.0, 1.0))));
      };
      const auto end_line = [&] {
        add_line(TrueLine::outline, line, profile, i);
        line.clear();
      };
      for (int k = 0; k <= kSteps; ++k) {
        const double t = double(k) / kSteps, before = std::max(0.0, t - 1.0 / kSteps);
        const bool here = has_outline(t), there = has_outline(before);
        // Both outlines meet where the cosine is 1, and run there fast.
        if (here != there) add_at(end_between(has_outline, here ? t : before, here ? before : t));
        if (here) add_at(t);
        if (!here && there) end_line();
      }
      end_line();
    }
  }

  /// The last place at which `holds` is true on the way from `yes`, where it is, to `no`.
  template <class Holds>
  static double end_between(const Holds& holds, double yes, double no) {
    for (int halving = 0; halving < 40; ++halving) {
      const double middle = (yes + no) / 2;
      (holds(middle) ? yes : no) = middle;
    }
    return yes;
  }

  /// Adds samples of a polyline over a piece of a profile.
  void add_line(TrueLine kind, const std::vector<Point3>& line, const Profile& profile, std::size_t i) {
    for (std::size_t k = 1, since = 0; k < line.size(); ++k) {
      const double length = glm::distance(line[since], line[k]);
      if (length < step_ && k + 1 < line.size()) continue;
      const int steps = std::max(1, static_cast<int>(std::ceil(length / step_)));
      const Point3 along = (line[k] - line[since]) / double(steps);
      for (int n = 0; n < steps && length > 0; ++n) {
        const Point3 at = line[since] + (n + 0.5) * along;
        const bool turns = since > 0 && n == 0 && glm::dot(on_page(points_.back().along, at), on_page(along, at)) < 0;
        points_.push_back({kind, at, along, std::hypot(at.x, at.y) + radius_of(profile, i), turns});
      }
      since = k;
    }
  }

  /// The part of a vector at a point that is seen in its length.
  Point3 on_page(const Point3& p, const Point3& at) const {
    const Point3 to = viewer_.from(at);
    return p - glm::dot(p, to) * to;
  }

  Viewer viewer_;
  double step_;
  std::vector<TruePoint> points_;
};

}  // namespace

void write_stl(const std::vector<std::array<Point3, 3>>& triangles, const std::filesystem::path& file) {
  std::ofstream out(file, std::ios::binary);
  const auto write = [&](const auto& value) { out.write(reinterpret_cast<const char*>(&value), sizeof value); };
  out.write(std::string(80, ' ').data(), 80);
  write(static_cast<std::uint32_t>(triangles.size()));
  for (const std::array<Point3, 3>& triangle : triangles) {
    for (int k = 0; k < 3; ++k) write(0.0f);  // readers take the normal from the corners
    for (const Point3& p : triangle)
      for (int axis = 0; axis < 3; ++axis) write(static_cast<float>(p[axis]));
    write(std::uint16_t{0});
  }
  if (!out.flush()) throw std::runtime_error("can't write " + file.string());
}

std::vector<TruePart> true_parts() {
  const Profile bar = rounded({{{0, 0}}, {{44, 0}}, {{44, 6}}, {{36, 11}}, {{26, 14.5}}, {{14, 16}}, {{0, 16}}});
  const Profile angle = rounded({{{0, 0}, 3}, {{40, 0}, 3}, {{40, 14}, 3}, {{14, 14}, 5}, {{14, 34}, 3}, {{0, 34}, 3}});
  const Profile bracket = rounded({{{0, 0}, 6}, {{36, 0}}, {{36, 3}}, {{3, 3}, 3}, {{3, 28}}, {{0, 28}}});
  const Extrusion plate{{rectangle({0, 0}, {50, 30}, 5), hole(circle({10, 15}, 4)), hole(circle({40, 15}, 6)),
                         hole(rectangle({18, 9}, {30, 21}, 3))},
                        7};
  const Profile flange = rounded({{{5, 0}}, {{20, 0}}, {{20, 5}}, {{9, 5}, 2}, {{9, 16.5}}, {{7.5, 18}}, {{5, 18}}});
  const Profile boss = rounded({{{0, 0}}, {{18, 0}}, {{18, 4}}, {{8, 4}, 3}, {{8, 16}, 2}, {{0, 16}}});
  const Profile washer = rounded({{{4, 0}}, {{15, 0}}, {{15, 10}}, {{8, 10}}, {{4, 6}}});
  const Profile cup = rounded({{{0, 0}}, {{14, 0}}, {{14, 20}}, {{8, 20}}, {{8, 8}, 2}, {{0, 8}}});
  const Profile ring = circle({15, 5}, 5);
  const Profile knob = rounded({{{0, 0}}, {{7, 0}}, {{7, 8}, 2}, {{16, 8}, 2}, {{16, 24}, 9}, {{0, 24}}});
  const Profile pulley =
      rounded({{{3, 0}}, {{20, 0}, 1}, {{20, 4}, 1}, {{14, 7}, 2}, {{14, 11}, 2}, {{20, 14}, 1}, {{20, 18}, 1}, {{3, 18}}});
  return {{"box", Extrusion{{rectangle({0, 0}, {40, 25}, 4)}, 12}},
          {"bar", Extrusion{{bar}, 15}},
          {"plate", plate},
          {"angle", Extrusion{{angle}, 10}},
          {"bracket", Extrusion{{bracket}, 20}},
          {"flange", Turning{flange}},
          {"boss", Turning{boss}},
          {"washer", Turning{washer}},
          {"cup", Turning{cup}},
          {"ring", Turning{ring}},
          {"knob", Turning{knob}},
          {"pulley", Turning{pulley}}};
}

void write_mesh(const TruePart& part, int facets, const std::filesystem::path& file) {
  write_stl(std::visit([&](const auto& shape) { return mesh_of(shape, facets); }, part.shape), file);
}

Point3 Viewer::from(const Point3& p) const { return glm::normalize(is_eye ? at - p : at); }

std::vector<TruePoint> true_lines(const TruePart& part, const Viewer& viewer, double step) {
  return std::visit([&](const auto& shape) { return Lines(viewer, step).of(shape); }, part.shape);
}

}  // namespace ligne::test
