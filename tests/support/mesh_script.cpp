#include "support/mesh_script.hpp"

#include "main/script.hpp"
#include "scene/creases/find_creases.hpp"
#include "scene/heal/heal.hpp"
#include "scene/patches/facet_graph.hpp"
#include "scene/patches/fillets.hpp"
#include "scene/patches/found_surfaces.hpp"
#include "scene/patches/patch_circles.hpp"
#include "scene/patches/refine/refine_scene.hpp"
#include "scene/patches/repeated_objects.hpp"
#include "scene/readers/reader.hpp"
#include "support/mesh_text.hpp"
#include "support/test.hpp"

namespace ligne::test {
namespace {

/// The variables of conditions.
constexpr std::array<std::string_view, 8> kItemVariables{"x", "y", "z", "above", "length", "cosine", "size", "area"};

/// A thing that was measured: where it is, and its numbers.
struct Item {
  std::vector<Point3> places;
  std::map<std::string, double> numbers;
};

using Sets = std::map<std::string, std::vector<Item>>;

Item edge_item(const Scene& scene, const Edge& edge) {
  const Point3 &a = scene.vertices[edge.v0], &b = scene.vertices[edge.v1];
  return {{a, b}, {{"length", glm::distance(a, b)}}};
}

Item surface_item(const PatchSurface& s, std::size_t faces, bool outward) {
  return {{s.at},
          {{"radius", s.radius},
           {"slope", s.slope},
           {"tube", s.tube},
           {"faces", faces},
           {"outward", outward},
           {"axis-x", s.axis.x},
           {"axis-y", s.axis.y},
           {"axis-z", s.axis.z},
           {"upright", std::abs(s.axis.z)},
           {"steepness", std::abs(s.slope)}}};
}

void add_surface(Sets& sets, SurfaceKind kind, const Item& item) {
  constexpr std::array<const char*, 6> kNames{"cylinders", "cones", "spheres", "tori", "extruded", "revolved"};
  sets[kNames[static_cast<std::size_t>(kind)]].push_back(item);
  sets["surfaces"].push_back(item);
}

/// Lines of creases from their free ends to the next junction.
std::vector<Item> loose_lines(const Scene& scene, const Topology& topology, const std::vector<std::uint8_t>& lines) {
  std::map<std::uint32_t, std::vector<std::uint32_t>> at;
  for (std::uint32_t e = 0; e < topology.edges.size(); ++e)
    for (const std::uint32_t v : {topology.edges[e].v0, topology.edges[e].v1})
      if (lines[e] == kCreaseLine) at[v].push_back(e);
  std::vector<Item> loose;
  for (const auto& [end, creases] : at) {
    if (creases.size() != 1) continue;
    double length = 0;
    std::uint32_t v = end;
    for (std::uint32_t e = creases[0];; e = at[v][at[v][0] == e ? 1 : 0]) {
      const Edge& edge = topology.edges[e];
      length += glm::distance(scene.vertices[edge.v0], scene.vertices[edge.v1]);
      v = edge.v0 == v ? edge.v1 : edge.v0;
      if (at[v].size() != 2) break;
    }
    loose.push_back({{scene.vertices[end]}, {{"length", length}}});
  }
  return loose;
}

class MeshScript {
 public:
  void run(const Script& script) {
    for (const ScriptStep& step : script.steps) {
      SCOPED_TRACE(step.place + ": " + step.line);
      std::string_view rest = step.line;
      const std::string verb = take_word(rest);
      if (const auto found = measures().find(verb); found != measures().end()) {
        measure(found->second, words_of(rest));
        for (const std::string& text : step.checks) {
          SCOPED_TRACE(text);
          check(text);
        }
      } else if (verb == "mesh") {
        mesh_ = {};
        scene_.reset();
      } else if (verb == "read" || verb == "corpus") {
        read(verb, rest, step.text);
      } else {
        mesh_.add(step.line);
        scene_.reset();
      }
    }
  }

 private:
  using Words = std::vector<std::string>;
  using Measure = void (MeshScript::*)(const Words&);
  static const std::map<std::string, Measure>& measures() {
    static const std::map<std::string, Measure> all{
        {"patches", &MeshScript::patches}, {"surfaces", &MeshScript::surfaces},       {"circles", &MeshScript::circles},
        {"fillets", &MeshScript::fillets}, {"repetitions", &MeshScript::repetitions}, {"facets", &MeshScript::facets},
        {"creases", &MeshScript::creases}, {"healed", &MeshScript::healed},           {"refined", &MeshScript::refined}};
    return all;
  }

  void read(const std::string& verb, std::string_view rest, const std::string& text) {
    Warnings warnings;
    if (verb == "corpus") {
      scene_ = read_scene(LIGNE_SOURCE_DIR "/tests/corpus/" + std::string(rest) + ".json", {}, warnings);
      return;
    }
    const std::string format = take_word(rest), bytes = repeated(text.empty() ? unescaped(rest) : text);
    const std::map<std::string, ModelFormat> formats{{"obj", ModelFormat::obj},
                                                     {"ply", ModelFormat::ply},
                                                     {"gltf", ModelFormat::gltf},
                                                     {"asc", ModelFormat::asc_3d_studio}};
    scene_ = read_scene({std::as_bytes(std::span(bytes)), "model"}, formats.at(format), {.shading = true}, warnings);
  }

  void measure(Measure how, const Words& words) {
    if (!scene_) scene_ = mesh_.scene();
    sets_.clear(), numbers_.clear();
    numbers_["faces"] = static_cast<double>(scene_->faces.size());
    (this->*how)(words);
  }

  /// A check of a set that the measure does not make is a mistake.
  void make_sets(std::initializer_list<const char*> names) {
    for (const char* name : names) sets_[name];
  }

  void patches(const Words& words) {
    FoundPatches found(*scene_);
    if (!words.empty()) {
      EXPECT_EQ(words[0], "without-loose");
      drop_loose_tangents(found.scene, found.topology, found.patches, std::vector<std::uint8_t>(found.edges.size(), 0),
                          found.edges);
    }
    make_sets({"unknown", "inside", "tangent", "sharp", "surfaces", "cylinders", "cones", "spheres", "tori", "extruded",
               "revolved"});
    constexpr std::array<const char*, 4> kNames{"unknown", "inside", "tangent", "sharp"};
    for (std::size_t e = 0; e < found.edges.size(); ++e)
      sets_[kNames[static_cast<std::size_t>(found.edges[e])]].push_back(edge_item(found.scene, found.topology.edges[e]));
    for (const auto& [patch, faces] : found.faces())
      add_surface(sets_, found.patches.list[patch].surface.kind,
                  surface_item(found.patches.list[patch].surface, faces, found.patches.list[patch].outward));
    numbers_["edges"] = static_cast<double>(found.edges.size());
    numbers_["freeform-faces"] = static_cast<double>(std::ranges::count(found.patches.is_freeform, 1));
    numbers_["faces-without"] = static_cast<double>(std::ranges::count(found.patches.patch_of, kNone));
    numbers_["plane-edges"] = static_cast<double>(found.patches.plane_edges.size());
  }

  void surfaces(const Words&) {
    const FoundPatches found(*scene_);
    make_sets({"surfaces", "cylinders", "cones", "spheres", "tori", "extruded", "revolved"});
    const FoundSurfaces surfaces = found_surfaces(found.scene, found.patches);
    std::vector<std::size_t> faces(surfaces.list.size(), 0);
    for (const std::uint32_t number : surfaces.of_face)
      if (number != kNone) ++faces.at(number);
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const FoundSurface& s = surfaces.list[i];
      EXPECT_EQ(s.faces, faces[i]) << i;
      EXPECT_GT(faces[i], 0u) << i;
      Item item = surface_item(s.surface, s.faces, s.outward);
      item.numbers.insert({{"from", s.along[0]},
                           {"to", s.along[1]},
                           {"turn", s.turn},
                           {"sag", s.sag},
                           {"error", s.error},
                           {"object", s.object}});
      add_surface(sets_, s.surface.kind, item);
    }
    numbers_["numbered-faces"] = static_cast<double>(surfaces.of_face.size());
  }

  void facets(const Words&) {
    make_sets({"facets"});
    const Topology topology = build_topology(*scene_);
    const auto [begin, end] = edges_of(topology, scene_->objects.at(0));
    const FacetGraph graph =
        facet_graph(*scene_, topology, scene_->objects[0], {begin, end}, face_normals(*scene_, topology));
    for (std::size_t i = 0; i < graph.size(); ++i)
      sets_["facets"].push_back({{Point3(0)}, {{"size", graph.faces[i].size()}, {"area", graph.area[i]}}});
  }

  void repetitions(const Words&) {
    const auto found = find_repetitions(*scene_, build_topology(*scene_));
    for (std::size_t i = 0; i < found.size(); ++i) numbers_["original-" + std::to_string(i)] = found[i].original;
    numbers_["objects"] = static_cast<double>(found.size());
  }

  void circles(const Words&) {
    const FoundPatches found(*scene_);
    make_sets({"circles"});
    for (const PatchCircle& c : patch_circles(found.scene, found.topology, found.patches))
      sets_["circles"].push_back({{c.centre}, {{"radius", c.radius}, {"upright", std::abs(c.axis.z)}}});
  }

  void fillets(const Words& words) {
    const FoundPatches found(*scene_);
    make_sets({"lines", "straight"});
    const FilletMiddles middles =
        fillet_middles(found.scene, found.topology, found.patches, found.edges, number_of(words.at(0)));
    for (const FaceLine& line : middles.lines) {
      EXPECT_EQ(line.points.size(), line.faces.size() + 1);
      double length = 0;
      for (std::size_t i = 0; i + 1 < line.points.size(); ++i) length += glm::distance(line.points[i], line.points[i + 1]);
      const double chord = glm::distance(line.points.front(), line.points.back());
      Item item{line.points, {{"length", length}, {"closed", line.closed}}};
      if (length < chord * (1 + 1e-5)) sets_["straight"].push_back(item);
      sets_["lines"].push_back(item);
    }
    numbers_["fillet-faces"] = static_cast<double>(std::ranges::count(middles.is_fillet, 1));
  }

  void creases(const Words& words) {
    const Topology topology = build_topology(*scene_);
    make_sets({"edges", "borders", "creases", "walls", "loose"});
    CreaseAngles angles;
    if (!words.empty()) angles.faces = number_of(words[0]);
    if (words.size() > 1) angles.surfaces = number_of(words[1]);
    const Creases found = find_creases(*scene_, topology, angles);
    for (std::size_t e = 0; e < topology.edges.size(); ++e) {
      const Edge& edge = topology.edges[e];
      Item item = edge_item(*scene_, edge);
      const bool is_border = edge.face1 == kNone;
      item.numbers["cosine"] = is_border ? 0 : glm::dot(face_normal(*scene_, edge.face0), face_normal(*scene_, edge.face1));
      sets_["edges"].push_back(item);
      if (is_border) sets_["borders"].push_back(item);
      if (found.lines[e] != 0) sets_["creases"].push_back(item);
    }
    Point3 middle(0, 0, 0);
    for (const WallEdge& wall : found.walls) {
      const Edge& edge = topology.edges[wall.edge];
      middle += (scene_->vertices[edge.v0] + scene_->vertices[edge.v1]) / (2.0 * static_cast<double>(found.walls.size()));
    }
    for (const WallEdge& wall : found.walls) {
      Item& item = sets_["walls"].emplace_back(edge_item(*scene_, topology.edges[wall.edge]));
      item.numbers["inward"] = glm::dot(wall.side, middle - 0.5 * (item.places[0] + item.places[1]));
    }
    sets_["loose"] = loose_lines(*scene_, topology, found.lines);
    numbers_.insert({{"fading", found.fading},
                     {"continued", found.continued},
                     {"smooth-by-file", found.smooth_by_file},
                     {"sharp-by-file", found.sharp_by_file},
                     {"straight-sheets", found.straight_sheets},
                     {"traced", found.traced},
                     {"untraced", found.untraced},
                     {"spurs", found.spurs},
                     {"short-chains", found.short_chains},
                     {"scans", found.scans.size()},
                     {"precision", scene_->objects.at(0).precision}});
  }

  void healed(const Words& words) {
    Scene scene = *scene_;
    make_sets({"borders"});
    Topology topology = build_topology(scene);
    HealOptions options;
    if (!words.empty()) options.sew_distance = number_of(words[0]);
    const HealReport report = heal(scene, topology, options);
    for (const Edge& edge : topology.edges)
      if (edge.face1 == kNone) sets_["borders"].push_back(edge_item(scene, edge));
    // clang-format off
    numbers_ = {{"faces", scene.faces.size()}, {"vertices", scene.vertices.size()}, {"faces-twice", report.faces_twice}, {"changed", !report.nothing()},
                {"objects-twice", report.objects_twice}, {"collapsed", report.vertices_collapsed}, {"at-steps", report.vertices_at_steps},
                {"flagged-edges", std::ranges::count_if(topology.edge_flags, [](std::uint16_t flags) { return flags != 0; })}};
    // clang-format on
  }

  void refined(const Words& words) {
    make_sets({"edges", "borders", "creases"});
    const Topology topology = build_topology(*scene_);
    Creases creases = find_creases(*scene_, topology, {});
    numbers_["given-creases"] = static_cast<double>(std::ranges::count(creases.lines, kCreaseLine));
    const RefineLimits limits{number_of(words.at(0)), [](const Point3&) { return 1.0; }};
    const std::optional<RefinedScene> finer = refine_scene(*scene_, topology, limits, creases);
    numbers_["refined"] = finer.has_value();
    if (!finer) return;
    const Patches& patches = creases.patches;
    numbers_["finer-faces"] = static_cast<double>(finer->scene.faces.size());
    numbers_["scans-in-place"] = static_cast<double>(std::ranges::count_if(creases.scans, [&](const ScanObject& scan) {
      return std::ranges::any_of(finer->scene.objects, [&](const Object& object) {
        const EdgeRange range = edges_of(finer->topology, object);
        return scan.face_begin == object.face_begin && scan.face_end == object.face_end && scan.edge_begin == range.begin &&
               scan.edge_end == range.end;
      });
    }));
    ASSERT_EQ(finer->face_of.size(), finer->scene.faces.size());
    ASSERT_EQ(patches.patch_of.size(), finer->scene.faces.size());
    ASSERT_EQ(creases.lines.size(), finer->topology.edges.size());
    for (std::size_t e = 0; e < finer->topology.edges.size(); ++e) {
      const Edge& edge = finer->topology.edges[e];
      Item item = edge_item(finer->scene, edge);
      std::array<double, 2> off{0, 0};  // of the ends and of the middle
      for (const std::uint32_t face : {edge.face0, edge.face1}) {
        if (face == kNone || patches.patch_of[face] == kNone) continue;
        ++item.numbers["surfaces"];
        const PatchSurface& surface = patches.list[patches.patch_of[face]].surface;
        const auto distance = [&](const Point3& p) { return std::abs(surface.distance(p)); };
        off = {std::max({off[0], distance(item.places[0]), distance(item.places[1])}),
               std::max(off[1], distance(0.5 * (item.places[0] + item.places[1])))};
      }
      const int flags = finer->topology.edge_flags[e] & (kEdgeManyFaces | kEdgeUnlikeWound);
      item.numbers.insert({{"surfaces", 0}, {"ends-off", off[0]}, {"middle-off", off[1]}, {"flags", flags}});
      sets_["edges"].push_back(item);
      if (edge.face1 == kNone) sets_["borders"].push_back(item);
      if (creases.lines[e] == kCreaseLine) sets_["creases"].push_back(item);
      EXPECT_TRUE(finer->edge_of[e] == kNone || finer->edge_of[e] < topology.edges.size());
    }
  }

  /// The text with the numbers that were kept in place of their names.
  std::string with_kept(std::string text) const {
    for (const auto& [name, value] : kept_)
      for (std::size_t at; (at = text.find('$' + name)) != text.npos;) text.replace(at, name.size() + 1, as_text(value));
    return text;
  }

  void check(const std::string& text) {
    std::string_view rest = text;
    if (rest.starts_with("keep ")) {
      take_word(rest);
      const std::string name = take_word(rest);
      kept_[name] = values_of(std::string(rest)).at(0);
      return;
    }
    for (const char* op : {" = ", " != ", " <= ", " >= ", " < ", " > "}) {
      const std::size_t at = text.rfind(op);
      if (at == text.npos) continue;
      const std::string wanted = with_kept(text.substr(at + std::strlen(op)));
      const std::size_t sign = wanted.find(" +- ");
      const double tolerance = sign == wanted.npos ? 0 : number_of(wanted.substr(sign + 4));
      const std::vector<double> found = values_of(text.substr(0, at));
      EXPECT_FALSE(found.empty());
      const double right = number_of(wanted.substr(0, sign));
      for (const double value : found)
        EXPECT_TRUE(holds(value, take_word(rest = op + 1), right, tolerance)) << value << ", not" << op << right;
      return;
    }
    ADD_FAILURE() << "no check";
  }

  /// The values that a check compares: the number of things, or a number of each.
  std::vector<double> values_of(const std::string& text) const {
    const std::size_t where = text.find(" where ");
    const Words words = words_of(text.substr(0, where));
    const std::string& name = words.back();
    const std::size_t dot = name.find('.');
    if (const auto number = numbers_.find(name); number != numbers_.end()) return {number->second};
    std::vector<Item> items = sets_.at(name.substr(0, dot));
    if (where != text.npos) {
      const std::string formula = with_kept(text.substr(where + 7));
      const auto value = place_formula(formula + ";0;0", kItemVariables);
      std::erase_if(items, [&](const Item& item) {
        const auto number = [&](const char* of) { return item.numbers.contains(of) ? item.numbers.at(of) : 0; };
        return !std::ranges::all_of(item.places, [&](const Point3& p) {
          return value({p.x, p.y, p.z, mesh_.above(p), number("length"), number("cosine"), number("size"), number("area")})
                     .x > 0;
        });
      });
    }
    if (dot == name.npos) return {static_cast<double>(items.size())};
    std::vector<double> values;
    for (const Item& item : items) values.push_back(item.numbers.at(name.substr(dot + 1)));
    if (words[0] == "sum") return {std::accumulate(values.begin(), values.end(), 0.0)};
    if (words[0] == "most" && !values.empty()) return {*std::ranges::max_element(values)};
    return values;
  }

  MeshText mesh_;
  std::optional<Scene> scene_;
  Sets sets_;
  std::map<std::string, double> numbers_, kept_;
};

}  // namespace

bool add_mesh_scripts(const std::filesystem::path& folder) {
  return add_scripts(folder, [](const Script& script) { MeshScript().run(script); });
}

}  // namespace ligne::test
