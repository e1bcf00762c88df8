/// Tangent edges, which are drawn as whole lines: where they fade, cross free forms, have gaps, or are loose.

#include "main/script.hpp"
#include "patches/part_scenes.hpp"
#include "patches/patch_scenes.hpp"
#include "scene/creases/fading_creases.hpp"
#include "scene/creases/find_creases.hpp"
#include "scene/patches/borders/freeform_borders.hpp"
#include "scene/patches/borders/patch_edges.hpp"
#include "scene/patches/borders/straight_tangents.hpp"
#include "scene/patches/borders/tangent_gaps.hpp"
#include "scene/patches/borders/whole_borders.hpp"
#include "support/mesh_text.hpp"
#include "support/test.hpp"

namespace ligne::test {
namespace {

struct FoundCreases {
  Scene scene;
  Topology topology;
  Creases creases;

  explicit FoundCreases(const std::vector<Corners>& polygons) : scene(scene_of(polygons)), topology(build_topology(scene)) {
    creases = find_creases(scene, topology, {});
  }
  const Point3& end(std::size_t e, bool second) const {
    return scene.vertices[second ? topology.edges[e].v1 : topology.edges[e].v0];
  }
  bool is_crease(std::size_t e) const { return creases.lines[e] == kCreaseLine; }
};

// Creases that end in the middle of a surface: those of a coarse smooth mesh go, long ones that stand out stay.

/// Creases may become flat over a long way, as where a plane cuts a coil, but not by one edge at their end: a bowed sheet,
/// folded along its middle by an angle that falls from `most` degrees at one end to 0 at the other.
TEST(FadingCreases, DoNotEndWithAFewFlatEdges) {
  for (const double most : {58.0, 150.0}) {
    FoundCreases found(mesh_of("grid 16 x 48 triangles: u-8; 20*v/48-10; -tan(" + as_text(most) +
                               "/2*(1-v/48)*pi/180)*abs(u-8)-0.01*(u-8)^2-0.01*(20*v/48-10)^2")
                           .polygons());
    std::vector<Bend> bends(found.topology.edges.size(), Bend::none);
    std::vector<BendEnd> ends;
    std::vector<std::uint32_t> middle;
    for (std::uint32_t e = 0; e < bends.size(); ++e) {
      if (found.end(e, false).x != 0 || found.end(e, true).x != 0) continue;
      bends[e] = Bend::strong;
      middle.push_back(e);
      for (const std::uint32_t v : {found.topology.edges[e].v0, found.topology.edges[e].v1}) ends.push_back({v, e});
    }
    std::sort(ends.begin(), ends.end());
    const std::vector<glm::vec3> normals = face_normals(found.scene, found.topology);
    const EdgeRows rows(found.scene, found.topology, normals);
    const std::vector<double> sizes{30};
    const std::vector<std::uint8_t> is_freeform(found.scene.faces.size(), 1);
    const std::function<bool(std::uint32_t)> never = [](std::uint32_t) { return false; };
    drop_fading_creases(found.scene, found.topology, {rows, ends, sizes, is_freeform, never, never}, bends);
    std::size_t flat = 0, dropped = 0;
    for (const std::uint32_t e : middle) {
      const bool is_flat = rows.bend(e, found.topology.edges[e].face0) < 5 * kPi / 180;
      flat += is_flat;
      dropped += bends[e] == Bend::weak;
      EXPECT_TRUE(is_flat || bends[e] == Bend::strong);
    }
    EXPECT_GT(flat, 0u);
    EXPECT_EQ(dropped, most > 100 ? flat : 0);
  }
}

// Free forms between planes.

/// A free form of one facet's depth, along y, that turns by about 17 degrees between a cylinder and a plane.
TEST(ShallowFreeforms, RunIntoACylinderAndAPlane) {
  const double radius = 14, plane_angle = 12, plane_distance = 13.607;
  const auto normal = [](double degrees) { return Point3(std::sin(degrees * kPi / 180), 0, std::cos(degrees * kPi / 180)); };
  // The border of the cylinder wavers round 5 degrees, and that of the plane lies as far beyond the line where both meet.
  const std::array<double, 7> border{-5, -4.6, -5.3, -4.7, -5.4, -4.9, -5.2};
  const int rows = 6, columns = 8;
  const auto along = [](int v) { return Point3(0, 3.0 * v, 0); };
  const auto on_cylinder = [&](int u, int v) {
    return radius * normal(u < columns ? -45 + 5.0 * u : border[static_cast<std::size_t>(v)]) + along(v);
  };
  const auto on_form = [&](int u, int v) {
    const double from = border[static_cast<std::size_t>(v)], turn = (plane_angle - from) * kPi / 180;
    const double way = (plane_distance - radius * std::cos(turn)) / std::sin(turn);
    const Point3 begin = radius * normal(from);
    return begin + (u == 0 ? 0.0 : way) * (normal(from + 90) + normal(plane_angle + 90)) + along(v);
  };
  std::vector<Corners> polygons;
  add_grid(polygons, columns, rows, true, on_cylinder);
  add_grid(polygons, 1, rows, true, on_form);
  const Point3 beyond = 20.0 * normal(plane_angle + 90), before = -20.0 * normal(45);
  Corners last{on_form(1, 0) + beyond, on_form(1, rows) + beyond};
  Corners first{on_cylinder(0, rows) + before, on_cylinder(0, 0) + before};
  for (int v = 0; v <= rows; ++v) {
    last.push_back(on_form(1, rows - v));
    first.push_back(on_cylinder(0, v));
  }
  polygons.push_back(last);
  polygons.push_back(first);
  const FoundPatches found(polygons);
  std::size_t count = 0;
  for (std::size_t e = 0; e < found.edges.size(); ++e) {
    const auto is_at_border = [&](std::uint32_t v) {
      const Point3& p = found.scene.vertices[v];
      return std::abs(std::hypot(p.x, p.z) - radius) < 1e-4 && p.x > radius * normal(-8).x;
    };
    const Edge& edge = found.topology.edges[e];
    count += is_at_border(edge.v0) && is_at_border(edge.v1) && found.edges[e] == PatchEdge::tangent;
  }
  EXPECT_EQ(count, static_cast<std::size_t>(rows));
  EXPECT_EQ(found.count(PatchEdge::sharp), 0u);
}

// For gaps/tangent_gaps.txt: gaps in tangent lines are closed where they are shorter than the line, and the line goes where
// they are longer.

/// A border of a cylinder and a free form along x, of edges of length 1: t is tangent, u is unknown, i is inside a surface,
/// l is another line. At a slash the border turns by 90 degrees. Returns the same letters after close_tangent_gaps().
std::string closed(const std::string& border) {
  Scene scene;
  Topology topology;
  Point3 at(0, 0, 0), way(1, 0, 0);
  scene.vertices.push_back(at);
  std::vector<PatchEdge> kinds;
  std::vector<std::uint8_t> is_line;
  for (const char c : border) {
    if (c == '/') {
      way = Point3(-way.y, way.x, 0);
      continue;
    }
    const auto v = static_cast<std::uint32_t>(kinds.size());
    topology.edges.push_back({v, v + 1, 0, 1});
    scene.vertices.push_back(at += way);
    kinds.push_back(c == 't' ? PatchEdge::tangent : c == 'i' ? PatchEdge::inside : PatchEdge::unknown);
    is_line.push_back(c == 'l');
  }
  topology.edge_flags.assign(kinds.size(), 0);
  Patches patches;
  patches.list.resize(1);
  patches.patch_of = {0, kNone};
  patches.is_freeform = {0, 1};
  close_tangent_gaps(scene, topology, patches, is_line, kinds);
  std::string after;
  std::size_t e = 0;
  for (const char c : border) {
    if (c == '/' || c == 'l') {
      after += c;
      e += c == 'l';
      continue;
    }
    const PatchEdge kind = kinds[e++];
    after += kind == PatchEdge::tangent ? 't' : kind == PatchEdge::inside ? 'i' : 'u';
  }
  return after;
}

/// For gaps/straight_tangents.txt: a tangent line through points X,Y. Triangles fill the space between it and the line past
/// its points with a star; all is flat. Returns the numbers of the points through which straighten_tangents() leads it.
std::string straightened(const std::string& text) {
  std::vector<Corners> polygons;
  Corners line, past;
  for (const std::string& word : words_of(text)) {
    line.push_back(point_of(word.substr(word[0] == '*') + ",0"));
    if (word[0] == '*' || line.size() == 1) continue;
    const std::size_t first =
        past.empty() ? 0 : static_cast<std::size_t>(std::ranges::find(line, past.back()) - line.begin());
    for (std::size_t i = first + 1; i + 1 < line.size(); ++i) polygons.push_back({line[first], line[i + 1], line[i]});
    polygons.push_back({line.back(), line[first], {line.back().x, -50, 0}});
    past.push_back(line.back());
  }
  for (std::size_t i = 1; i < line.size(); ++i) polygons.push_back({line[i - 1], line[i], {line[i].x, 50, 0}});
  const Scene scene = scene_of(polygons, true);
  const Topology topology = build_topology(scene);
  const auto number = [&](std::uint32_t v) {
    return static_cast<std::size_t>(std::ranges::find(line, scene.vertices[v]) - line.begin());
  };
  std::vector<PatchEdge> kinds;
  for (const Edge& edge : topology.edges) {
    const auto [a, b] = std::minmax({number(edge.v0), number(edge.v1)});
    kinds.push_back(b == a + 1 && b < line.size() ? PatchEdge::tangent : PatchEdge::unknown);
  }
  straighten_tangents(scene, topology, std::vector<std::uint8_t>(kinds.size(), 0), kinds);
  std::set<std::size_t> left;
  for (std::size_t e = 0; e < kinds.size(); ++e) {
    if (kinds[e] == PatchEdge::tangent) left.insert({number(topology.edges[e].v0), number(topology.edges[e].v1)});
  }
  std::string numbers;
  for (const std::size_t i : left) numbers += std::to_string(i);
  return numbers;
}

[[maybe_unused]] const bool gaps_are_added =
    add_function_scripts(LIGNE_SOURCE_DIR "/tests/patches/gaps", {{"closed", closed}, {"straightened", straightened}});

// Tangent edges that are dropped: chains that end freely, hooks, small rings, steps from facet to facet.

/// A chain of tangent edges between two faces. The edges have length 1 and are parallel to the axis of a cylinder, on which
/// the first face lies.
struct TangentChain {
  bool is_beside_plane = true;
  double width = 1;        ///< of both faces
  double object_size = 0;  ///< length of the object along the chain; 0: that of the chain
  bool is_ring = false;    ///< whether the last edge ends where the first one begins; otherwise both ends are free
  bool is_row = false;     ///< whether the first face is a free form instead
  bool is_held = false;    ///< whether another line ends at its beginning
  double step = 0;         ///< length of the fourth edge across the chain; 0: it goes straight on
};

/// Number of tangent edges that are left of a chain of so many.
std::size_t tangents_left(int edges, const TangentChain& chain = {}) {
  Topology topology;
  Scene scene;
  for (int i = 0; i < edges; ++i) {
    const auto v = static_cast<std::uint32_t>(i);
    topology.edges.push_back({v, chain.is_ring && i + 1 == edges ? 0 : v + 1, 0, 1});
    scene.vertices.emplace_back(chain.step > 0 && i > 3 ? i - 1 : i, i > 3 ? chain.step : 0, 0);
  }
  scene.vertices.emplace_back(edges, chain.step, 0);
  scene.vertices.emplace_back(0, chain.width, 0);
  scene.vertices.emplace_back(0, -chain.width, 0);
  scene.vertices.emplace_back(chain.object_size, 0, 0);
  scene.objects.resize(1);
  scene.objects[0].vertex_end = static_cast<std::uint32_t>(scene.vertices.size());
  const auto end = static_cast<std::uint32_t>(edges);
  scene.faces.add_face(std::array{0u, end, end + 1});
  scene.faces.add_face(std::array{0u, end + 2, end});
  std::vector<std::uint8_t> is_line(topology.edges.size(), 0);
  std::vector<PatchEdge> kinds(topology.edges.size(), PatchEdge::tangent);
  if (chain.is_held) {
    topology.edges.push_back({0, end + 1, 0, 1});
    is_line.push_back(1);
    kinds.push_back(PatchEdge::unknown);
  }
  topology.edge_flags.assign(topology.edges.size(), 0);
  Patches patches;
  patches.list.resize(1);
  patches.list[0].surface.axis = Point3(1, 0, 0);
  patches.patch_of = {chain.is_row ? kNone : 0, kNone};
  patches.is_freeform = {chain.is_row, !chain.is_beside_plane};
  drop_loose_tangents(scene, topology, patches, is_line, kinds);
  return static_cast<std::size_t>(std::count(kinds.begin(), kinds.end(), PatchEdge::tangent));
}

/// Number of tangent edges that are left of a line that turns a corner behind its first eight edges, goes on for `beyond`
/// edges of length 0.5, beside a free form and wide faces. On the other side is a plane, and both ends are free, or there is
/// a surface, and another line joins both ends.
std::size_t tangents_left_at_hook(int beyond, bool is_beside_surface) {
  Topology topology;
  Scene scene;
  for (int i = 0; i <= 8 + beyond; ++i) scene.vertices.emplace_back(3 * std::min(i, 8), 0.5 * std::max(0, i - 8), 0);
  for (std::uint32_t v = 0; v + 1 < scene.vertices.size(); ++v) topology.edges.push_back({v, v + 1, 0, 1});
  scene.objects.resize(1);
  scene.objects[0].vertex_end = static_cast<std::uint32_t>(scene.vertices.size());
  scene.faces.add_face(std::array{0u, 1u, scene.objects[0].vertex_end - 1});
  scene.faces.add_face(std::array{0u, scene.objects[0].vertex_end - 1, 1u});
  std::vector<std::uint8_t> is_line(topology.edges.size(), 0);
  std::vector<PatchEdge> kinds(topology.edges.size(), PatchEdge::tangent);
  Patches patches;
  patches.patch_of = {kNone, kNone};
  patches.is_freeform = {1, 0};
  if (is_beside_surface) {
    topology.edges.push_back({0, static_cast<std::uint32_t>(topology.edges.size()), 0, 1});
    is_line.push_back(1);
    kinds.push_back(PatchEdge::unknown);
    patches.list.resize(1);
    patches.patch_of[1] = 0;
  }
  topology.edge_flags.assign(topology.edges.size(), 0);
  drop_loose_tangents(scene, topology, patches, is_line, kinds);
  return static_cast<std::size_t>(std::count(kinds.begin(), kinds.end(), PatchEdge::tangent));
}

/// For loose/loose_tangents.txt: "EDGES", beyond the corner, and "surface".
std::string left_at_hook(const std::string& text) {
  return std::to_string(tangents_left_at_hook(std::stoi(text), text.ends_with("surface")));
}

/// For loose/loose_tangents.txt: "EDGES", of a chain, and "free-forms", "ring", "held", "row", "width=W", "object=LENGTH" or
/// "step=LENGTH".
std::string left_of_chain(const std::string& text) {
  TangentChain chain;
  for (const std::string& word : test::words_of(text)) {
    const std::size_t equals = word.find('=');
    const double value = equals == word.npos ? 0 : std::stod(word.substr(equals + 1));
    if (word == "free-forms") chain.is_beside_plane = false;
    if (word == "ring") chain.is_ring = true;
    if (word == "held") chain.is_held = true;
    if (word == "row") chain.is_row = true;
    if (word.starts_with("width")) chain.width = value;
    if (word.starts_with("object")) chain.object_size = value;
    if (word.starts_with("step")) chain.step = value;
  }
  return std::to_string(tangents_left(std::stoi(text), chain));
}

[[maybe_unused]] const bool loose_are_added =
    test::add_function_scripts(LIGNE_SOURCE_DIR "/tests/patches/loose", {{"chain", left_of_chain}, {"hook", left_at_hook}});

// Edges that are decided by the whole border of a patch.

/// A cylinder of radius 10 that becomes a cone at z = 0.
std::vector<Corners> pointed_shaft(int facets, double degrees) {
  return turned_body(facets, {{10, -20}, {10, 0}, {10 - 8 * std::tan(degrees * kPi / 180), 8}});
}

/// The edges of the ring at z = 0.
std::vector<std::size_t> ring_of(const FoundPatches& found) {
  std::vector<std::size_t> ring;
  for (std::size_t e = 0; e < found.edges.size(); ++e) {
    const Edge& edge = found.topology.edges[e];
    if (found.scene.vertices[edge.v0].z == 0 && found.scene.vertices[edge.v1].z == 0) ring.push_back(e);
  }
  return ring;
}

/// The ring of a shaft where so many edges have evidence of a kind, and all others are tangent.
std::vector<PatchEdge> ring_with(std::size_t count, BorderEvidence kind) {
  FoundPatches found(pointed_shaft(24, 20));
  const std::vector<std::size_t> ring = ring_of(found);
  std::vector<BorderEvidence> evidence(found.edges.size(), BorderEvidence::none);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    evidence[ring[i]] = i < count ? kind : BorderEvidence::tangent;
    found.edges[ring[i]] = i < count ? PatchEdge::unknown : PatchEdge::tangent;
  }
  decide_by_whole_borders(found.scene, found.topology, found.patches, evidence, found.edges);
  std::vector<PatchEdge> kinds;
  for (const std::size_t e : ring) kinds.push_back(found.edges[e]);
  return kinds;
}

TEST(WholeBorders, MostOfAChainDecidesForTheRest) {
  EXPECT_EQ(std::ranges::count(ring_with(9, BorderEvidence::open), PatchEdge::tangent), 24);
  EXPECT_EQ(std::ranges::count(ring_with(10, BorderEvidence::open), PatchEdge::tangent), 14);
  EXPECT_EQ(std::ranges::count(ring_with(2, BorderEvidence::against), PatchEdge::tangent), 24);
  EXPECT_EQ(std::ranges::count(ring_with(3, BorderEvidence::against), PatchEdge::tangent), 21);
}

// Creases of free forms: whole rings of rims, rims of bevels, and nothing inside roundings.

/// A coarse bevel: two wide sides at an angle of 110 degrees, with four narrow strips between them. It bends along the five
/// rulings, most along the middle one: by middle_degrees(y) there, and evenly along the others. At y = 0 a wall closes it,
/// at an angle of 90 degrees.
std::vector<Corners> bevel(const std::function<double(double)>& middle_degrees) {
  constexpr int kLength = 24, kRulings = 5;
  constexpr double kTotalDegrees = 110, kSide = 12, kStrip = 2;
  const auto profile = [&](int y) {
    std::vector<Point3> points{{-kSide, y, 0}, {0, y, 0}};
    double direction = 0;  // degrees
    for (int k = 0; k < kRulings; ++k) {
      direction += k == kRulings / 2 ? middle_degrees(y) : (kTotalDegrees - middle_degrees(y)) / (kRulings - 1);
      const double width = k + 1 == kRulings ? kSide : kStrip, angle = direction * kPi / 180;
      points.push_back(points.back() + width * Point3(std::cos(angle), 0, -std::sin(angle)));
    }
    return points;
  };
  std::vector<Corners> polygons;
  add_grid(polygons, kRulings + 1, kLength, true, [&](int k, int y) { return profile(y)[static_cast<std::size_t>(k)]; });
  Corners wall = profile(0);
  wall.push_back({-kSide, 0, wall.back().z});
  polygons.push_back(wall);
  return polygons;
}

/// The length of the creases along the middle ruling of a bevel, which lies between these places on the x axis.
double middle_crease(const FoundCreases& found) {
  constexpr double kLow = 3, kHigh = 3.7;
  double length = 0;
  for (std::size_t e = 0; e < found.topology.edges.size(); ++e) {
    const Point3 &a = found.end(e, false), &b = found.end(e, true);
    const bool is_on_ruling = a.y != b.y && std::min(a.x, b.x) > kLow && std::max(a.x, b.x) < kHigh;
    if (is_on_ruling && found.is_crease(e)) length += glm::distance(a, b);
  }
  return length;
}

TEST(WholeRings, OfABevelKeepARimThatLeadsToAnotherCrease) {
  // The rim begins at the wall, and fades halfway.
  const FoundCreases found(bevel([](double y) { return 44 - y; }));
  EXPECT_NEAR(middle_crease(found), 12, 1.5);
}

TEST(WholeRings, OfABevelHaveNoLineThatMeetsNoOther) {
  const FoundCreases found(bevel([](double y) { return 42 - (y - 12) * (y - 12) / 4; }));
  EXPECT_EQ(middle_crease(found), 0);
}

}  // namespace
}  // namespace ligne::test
