#include "solid.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace ligne::examples {
namespace {

Ring reversed(Ring ring) {
  std::reverse(ring.begin(), ring.end());
  return ring;
}

/// Lengths are written with up to four decimals.
constexpr double kUnitsPerLength = 1e4;

std::string length(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.4f", value);
  std::string trimmed = text;
  trimmed.erase(trimmed.find_last_not_of('0') + 1);
  if (trimmed.back() == '.') trimmed.pop_back();
  return trimmed == "-0" ? "0" : trimmed;
}

/// Whether the four points, rounded as they are written, lie in one plane exactly.
bool flat_when_written(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  __extension__ using Wide = __int128;
  const auto whole = [](double value) { return static_cast<Wide>(std::llround(value * kUnitsPerLength)); };
  const auto difference = [&](const Point3& p) {
    return std::array<Wide, 3>{whole(p.x) - whole(a.x), whole(p.y) - whole(a.y), whole(p.z) - whole(a.z)};
  };
  const auto u = difference(b), v = difference(c), w = difference(d);
  return u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) + u[2] * (v[0] * w[1] - v[1] * w[0]) == 0;
}

std::string index_list(const Ring& ring) {
  std::string text = "[";
  for (std::size_t i = 0; i < ring.size(); ++i) text += (i ? "," : "") + std::to_string(ring[i]);
  return text + "]";
}

}  // namespace

Ring Solid::add_ring(const Frame& frame, std::span<const Point2> outline, double h) {
  Ring ring;
  for (const Point2 p : outline) {
    ring.push_back(static_cast<std::uint32_t>(vertices.size()));
    vertices.push_back(frame.at(p, h));
  }
  return ring;
}

void Solid::add_wall(const Ring& lower, const Ring& upper) {
  assert(lower.size() == upper.size());
  for (std::size_t i = 0; i < lower.size(); ++i) {
    const std::size_t j = (i + 1) % lower.size();
    if (flat_when_written(vertices[lower[i]], vertices[lower[j]], vertices[upper[j]], vertices[upper[i]])) {
      faces.push_back({{lower[i], lower[j], upper[j], upper[i]}, {}});
    } else {
      faces.push_back({{lower[i], lower[j], upper[j]}, {}});
      faces.push_back({{lower[i], upper[j], upper[i]}, {}});
    }
  }
}

void Solid::add_bore_wall(const Ring& lower, const Ring& upper) { add_wall(reversed(lower), reversed(upper)); }

void Solid::add_top(const Ring& outer, const std::vector<Ring>& holes) {
  Face face{outer, {}};
  for (const Ring& hole : holes) face.holes.push_back(reversed(hole));
  faces.push_back(std::move(face));
}

void Solid::add_bottom(const Ring& outer, const std::vector<Ring>& holes) { faces.push_back({reversed(outer), holes}); }

void Solid::add_prism(const Frame& frame, std::span<const Point2> outline, double from, double to) {
  const Ring lower = add_ring(frame, outline, from), upper = add_ring(frame, outline, to);
  add_bottom(lower);
  add_wall(lower, upper);
  add_top(upper);
}

void add_turned(Solid& solid, const Frame& frame, std::span<const ProfilePoint> profile, int segments, Annuli annuli) {
  std::vector<Ring> rings;
  for (const ProfilePoint& p : profile) {
    const bool pole = p.r == 0;
    rings.push_back(solid.add_ring(frame, pole ? std::vector<Point2>{{0, 0}} : circle({0, 0}, p.r, segments), p.h));
  }
  const bool full = profile.front().r == 0 && profile.back().r == 0;
  const std::size_t pieces = full ? profile.size() - 1 : profile.size();
  for (std::size_t i = 0; i < pieces; ++i) {
    const std::size_t j = (i + 1) % profile.size();
    const Ring &a = rings[i], &b = rings[j];
    if (a.size() == 1 || b.size() == 1) {
      const Ring& rim = a.size() == 1 ? b : a;
      if (profile[i].h == profile[j].h) {
        a.size() == 1 ? solid.add_bottom(rim) : solid.add_top(rim);
        continue;
      }
      const std::uint32_t pole = a.size() == 1 ? a[0] : b[0];
      for (std::size_t k = 0; k < rim.size(); ++k) {
        const std::uint32_t p = rim[k], q = rim[(k + 1) % rim.size()];
        solid.faces.push_back({a.size() == 1 ? Ring{q, p, pole} : Ring{p, q, pole}, {}});
      }
    } else if (profile[i].h == profile[j].h && annuli == Annuli::faces_with_holes) {
      profile[i].r < profile[j].r ? solid.add_bottom(b, {a}) : solid.add_top(a, {b});
    } else {
      solid.add_wall(a, b);
    }
  }
}

std::vector<Point2> circle(Point2 centre, double radius, int segments, double phase) {
  std::vector<Point2> outline;
  for (int i = 0; i < segments; ++i) {
    const double angle = phase + 2 * std::numbers::pi * i / segments;
    outline.push_back(centre + radius * Point2(std::cos(angle), std::sin(angle)));
  }
  return outline;
}

std::string scene_text(const Model& model) {
  std::string text = "{\"format\": \"ligne-scene\", \"version\": 1, \"up\": \"z\",\n \"objects\": [";
  const char* object_separator = "\n";
  for (const Solid& solid : model.solids) {
    text += object_separator + std::string("{\"name\": \"") + solid.name + "\",\n \"vertices\": [";
    object_separator = ",\n";
    const char* separator = "\n";
    for (const Point3& v : solid.vertices) {
      text += separator + std::string("[") + length(v.x) + "," + length(v.y) + "," + length(v.z) + "]";
      separator = ",\n";
    }
    text += "],\n \"faces\": [";
    separator = "\n";
    for (const Face& face : solid.faces) {
      text += separator + std::string("{\"outer\":") + index_list(face.outer);
      separator = ",\n";
      for (std::size_t i = 0; i < face.holes.size(); ++i) text += (i ? "," : ",\"holes\":[") + index_list(face.holes[i]);
      text += face.holes.empty() ? "}" : "]}";
    }
    text += "]}";
  }
  return text + "]}\n";
}

std::string obj_text(const Model& model) {
  std::string text = "# An example model of Ligne Claire; y is up.\n";
  std::size_t base = 1;
  for (const Solid& solid : model.solids) {
    text += "o " + solid.name + "\n";
    for (const Point3& v : solid.vertices) text += "v " + length(v.x) + " " + length(v.z) + " " + length(-v.y) + "\n";
    for (const Face& face : solid.faces) {
      assert(face.holes.empty());
      text += "f";
      for (const std::uint32_t v : face.outer) text += " " + std::to_string(base + v);
      text += "\n";
    }
    base += solid.vertices.size();
  }
  return text;
}

}  // namespace ligne::examples
