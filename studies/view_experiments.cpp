// Experiments on successive views, named in the conclusion of [Boulle1980], with 1.2.2.3 b (front and back faces) and 3.4
// (sorting a nearly sorted list): the work of each view alone, and its work starting from the preceding view.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

#include <glm/geometric.hpp>

#include "scene/model/bounds.hpp"
#include "scene/model/topology.hpp"
#include "studies/experiments.hpp"
#include "studies/operations/sorts.hpp"
#include "studies/scenes/generators.hpp"
#include "view/projected_scene.hpp"
#include "visibility/bsp/bsp.hpp"
#include "visibility/convex_tree/convex_tree.hpp"
#include "visibility/registry.hpp"

namespace ligne::studies {
namespace {

/// The cameras of a camera path.
struct Movement {
  std::string name;
  std::vector<Camera> cameras;
};

/// The model rotates in front of the viewer by `degrees` per frame.
Movement turning(const Scene& scene, int frames, double degrees) {
  CameraRequest request;
  const Camera first = make_camera(request, scene);
  Movement movement{"turned by " + std::to_string(int(degrees)) + " degrees a view", {}};
  for (int i = 0; i < frames; ++i)
    movement.cameras.push_back(with_model_turned(first, ligne::Axis::z, bounding_box_centre(scene), degrees * i));
  return movement;
}

/// The eye moves past the model on a straight line and looks at its centre.
Movement walking(const Scene& scene, int frames) {
  Rect ground;
  double height = 0;
  for (const Point3& p : scene.vertices) {
    ground.extend({p.x, p.y});
    height = std::max(height, p.z);
  }
  const double size = std::max(ground.width(), ground.height());
  Movement movement{"the eye walks past", {}};
  for (int i = 0; i < frames; ++i) {
    CameraRequest request;
    const double share = double(i) / (frames - 1);
    request.eye = Point3{ground.min.x + size * (0.3 + 0.3 * share), ground.min.y - 1.5 * size, height + 0.5 * size};
    movement.cameras.push_back(make_camera(request, scene));
  }
  return movement;
}

ProjectedScene seen_by(const Scene& scene, const Topology& topology, const Camera& camera) {
  const View view = make_view(scene, camera, Frame{{{10, 10}, {287, 200}}}, Rect{{0, 0}, {297, 210}});
  return project(scene, topology, view, {LineClasses::features(), 30});
}

/// Operations summed over all views: each alone, and each starting from the results of the preceding one.
struct Gain {
  std::uint64_t alone = 0, following = 0;
};

std::uint64_t sum_of(const Statistics& statistics, std::initializer_list<std::string_view> names) {
  std::uint64_t sum = 0;
  for (const auto& [name, n] : statistics.counts) sum += std::ranges::find(names, name) != names.end() ? n : 0;
  return sum;
}

/// Pairs compared and faces cut by the priority list.
Gain list_gain(const Scene& scene, const Topology& topology, const Movement& movement) {
  const ligne::Method& newell = *find_method("newell");
  Gain gain;
  std::shared_ptr<const KeptVisibility> kept;
  for (const Camera& camera : movement.cameras) {
    const ProjectedScene projected = seen_by(scene, topology, camera);
    for (const bool follows : {false, true}) {
      VisibilityOptions options;
      options.wanted = kStrokes;
      if (follows) {
        options.keep = Keep::for_next_view;
        options.earlier = kept.get();
      }
      VisibilityResult result = newell.compute_visibility(projected, options);
      if (follows) kept = std::move(result.kept);
      (follows ? gain.following : gain.alone) +=
          sum_of(result.statistics, {"pairs compared", "cuts by a plane", "cuts on the page"});
    }
  }
  return gain;
}

/// The tree lies in model space and is built once.
Gain tree_gain(std::uint64_t pieces, const Movement& movement) { return {pieces * movement.cameras.size(), pieces}; }

/// Comparisons of the initial depth sort: a new quick sort, or a bubble sort starting from the preceding order (3.4).
Gain sort_gain(const Scene& scene, const Movement& movement) {
  struct Key {
    double depth;
    std::uint32_t face;
    bool operator<(const Key& o) const { return depth < o.depth; }
  };
  Gain gain;
  std::vector<std::uint32_t> before(scene.faces.size());
  for (std::uint32_t f = 0; f < before.size(); ++f) before[f] = f;
  bool first = true;
  for (const Camera& camera : movement.cameras) {
    const auto key = [&](std::uint32_t face) {
      double farthest = -1e300;
      for (const std::uint32_t v : scene.faces.contour(face, 0))
        farthest = std::max(farthest, camera_coordinates(camera, scene.vertices[v]).z);
      return Key{farthest, face};
    };
    std::vector<Key> anew, again;
    for (std::uint32_t f = 0; f < before.size(); ++f) anew.push_back(key(f));
    for (const std::uint32_t f : before) again.push_back(key(f));
    SortCounts alone, following;
    quick_sort(anew, alone);
    if (first) {
      quick_sort(again, following);
    } else {
      bubble_sort(again, following);
    }
    first = false;
    std::ranges::transform(again, before.begin(), &Key::face);
    gain.alone += alone.comparisons;
    gain.following += following.comparisons;
  }
  return gain;
}

/// Faces whose side is computed, and edges tested for being an outline.
struct FacingGain {
  Gain faces, edges;
  std::uint64_t wrong = 0;  ///< faces for which the preceding view gives a wrong side
};

/// Height of the eye over the face's plane, or sine of the angle between view direction and plane. Its sign is the side.
double side_of(const Camera& camera, const Point3& point, const Point3& normal) {
  return camera.perspective ? glm::dot(normal, camera.eye - point) : -glm::dot(normal, camera.forward);
}

/// Distance of two cameras in the unit of side_of(): no face's side_of() changes by more. A chord is shorter than its arc.
double way_between(const Camera& a, const Camera& b) {
  return a.perspective ? glm::distance(a.eye, b.eye) : glm::distance(a.forward, b.forward);
}

/// A face keeps its side until the viewer has moved by the distance from the face's plane (1.2.2.3 b), and an edge between
/// two such faces keeps its class.
FacingGain facing_gain(const Scene& scene, const Topology& topology, const Movement& movement) {
  const std::size_t n = scene.faces.size();
  std::vector<Point3> normals(n), points(n);
  for (std::uint32_t f = 0; f < n; ++f) {
    const auto contour = scene.faces.contour(f, 0);
    Point3 normal{0, 0, 0};
    for (std::size_t i = 2; i < contour.size(); ++i) {
      const Point3 &a = scene.vertices[contour[0]], &b = scene.vertices[contour[i - 1]], &c = scene.vertices[contour[i]];
      normal += glm::cross(b - a, c - a);
    }
    normals[f] = glm::length(normal) > 0 ? glm::normalize(normal) : normal;
    points[f] = scene.vertices[contour[0]];
  }
  FacingGain gain;
  std::vector<double> certain_until(n, -1);  // distance travelled up to which the side is certain
  std::vector<std::uint8_t> front(n, 0), asked(n, 0);
  double way = 0;
  for (std::size_t i = 0; i < movement.cameras.size(); ++i) {
    const Camera& camera = movement.cameras[i];
    if (i > 0) way += way_between(movement.cameras[i - 1], camera);
    for (std::uint32_t f = 0; f < n; ++f) {
      const double side = side_of(camera, points[f], normals[f]);
      asked[f] = way >= certain_until[f];
      if (asked[f]) {
        front[f] = side > 0;
        certain_until[f] = way + std::abs(side);
        ++gain.faces.following;
      }
      gain.wrong += front[f] != std::uint8_t{side > 0};
    }
    gain.faces.alone += n;
    for (const Edge& edge : topology.edges) {
      const bool two = edge.face0 < n && edge.face1 < n;
      gain.edges.alone += two;
      gain.edges.following += two && (asked[edge.face0] || asked[edge.face1]);
    }
  }
  return gain;
}

}  // namespace

Result study_successive_views(const StudyRequest& request) {
  constexpr const char* kAsked = "asked for in the conclusion, not measured";
  Table table{std::to_string(request.pick(4, 24)) + " views of a movement, each by itself and from the one before",
              {{"scene", ColumnKind::label},
               {"movement", ColumnKind::label},
               {"what is counted", ColumnKind::label},
               {"thesis", ColumnKind::source},
               {"each by itself", ColumnKind::count},
               {"from the one before", ColumnKind::count},
               {"gain", ColumnKind::measure}}};
  const int frames = request.pick(4, 24), blocks = request.pick(3, 8), boxes = request.pick(4, 30),
            rows = request.pick(6, 20);
  std::vector<NamedScene> scenes;
  scenes.push_back({"a city of " + std::to_string(blocks * blocks) + " boxes", city(blocks)});
  scenes.push_back({std::to_string(boxes) + " boxes that penetrate", penetrating_boxes(boxes)});
  scenes.push_back({"a ball, " + std::to_string(rows) + " rows", ball(rows)});
  scenes.insert(scenes.end(), request.models.begin(), request.models.end());
  std::uint64_t wrong = 0;
  std::vector<double> list_gains, sort_gains;
  for (NamedScene& named : scenes) {
    finish(named.scene);
    const Scene& scene = named.scene;
    const Topology topology = build_topology(scene);
    const BspTree bsp(scene, {});
    const ConvexTree convex(scene, {});
    for (const Movement& movement : {turning(scene, frames, 2), walking(scene, frames)}) {
      const auto add = [&](const char* what, const char* thesis, Gain gain) {
        const double times = double(gain.alone) / double(std::max<std::uint64_t>(gain.following, 1));
        table.rows.push_back({named.name, movement.name, what, thesis, gain.alone, gain.following, times});
        return times;
      };
      const FacingGain facing = facing_gain(scene, topology, movement);
      wrong += facing.wrong;
      list_gains.push_back(add("newell: pairs compared, and cuts", kAsked, list_gain(scene, topology, movement)));
      add("bsp: pieces put into the tree", kAsked, tree_gain(bsp.pieces().pieces().size(), movement));
      add("convex-tree: pieces put into the tree", kAsked, tree_gain(convex.pieces().pieces().size(), movement));
      add("faces asked for their side", "1.2.2.3 b: deduced from the view before", facing.faces);
      add("edges asked whether they are outlines", "1.2.2.3 b: deduced from the view before", facing.edges);
      sort_gains.push_back(
          add("comparisons of the sort: quick, bubble", "3.4: bubble, linear on a sorted list", sort_gain(scene, movement)));
    }
  }
  Result result;
  result.tables.push_back(std::move(table));
  const bool all_gain = std::ranges::min(list_gains) >= 1 && std::ranges::min(sort_gains) >= 1;
  result.finding = wrong > 0 ? Finding::no_longer : all_gain ? Finding::holds : Finding::in_part;
  char words[400];
  std::snprintf(
      words, sizeof words,
      "Trees are built once, and a face keeps its side until the viewer comes to its plane. The list of the view before "
      "spares a factor of %.1f to %.1f of newell's work, the bubble sort of its depths %.1f to %.1f of a quick sort's "
      "comparisons: one face that passes many others costs as many passes over the list.",
      std::ranges::min(list_gains), std::ranges::max(list_gains), std::ranges::min(sort_gains),
      std::ranges::max(sort_gains));
  result.sentence = words;
  return result;
}

}  // namespace ligne::studies
