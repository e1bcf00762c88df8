/// Smoothed directions of principal curvature:
///
/// 1. Normals are smoothed, so that small bumps do not count. Each triangle gets the second fundamental form that fits
///    the change of the normals along its sides, each node the mean over its triangles ([Rusinkiewicz2004], with forms
///    kept as tensors in space).
/// 2. A cross at the angle a in the tangent plane is the number exp(4 i a), which quarter turns do not change. The
///    smoothed crosses z stay near the crosses u of the curvature, the more so the higher their confidence c, and near
///    those of their neighbours. They minimise sum area c |z - u|^2 + length^2 sum w |z_i - turn_ij z_j|^2, one linear
///    system, solved by conjugate gradients.
/// 3. One of the two directions of a cross becomes the first. Neighbours agree along a spanning forest that joins the
///    nodes of highest confidence first. In each tree the first direction is the one in which the surface bends most.
/// 4. The first directions alone, as numbers exp(2 i a) that half turns do not change, are smoothed once more: where
///    neighbours could not agree, strokes bend.

#include "picture/hatching/form_field.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include <glm/geometric.hpp>

#include "base/disjoint_sets.hpp"
#include "base/parallel.hpp"
#include "scene/form/curvature.hpp"

namespace ligne {
namespace {

// Adjustable.
constexpr double kFlatTurn = 0.02;   ///< least turn, radians over `length`, that defines a direction
constexpr double kNormalPart = 0.5;  ///< of `length`; smaller bumps do not count

constexpr double kQuarter = std::numbers::pi / 2;

/// The directions that the curvature defines at a node.
struct CurvatureDirection {
  Complex cross{0, 0};  ///< of unit length, or zero
  double weight = 0;    ///< area times confidence, which is at most 1
  double first = 0;     ///< angle of the direction in which the surface bends most
  double first_weight = 0;
};

/// Confidence in a direction: the difference of the curvatures' turns over `length`, in radians, at most 1 and 0 below
/// kFlatTurn.
double confidence_of(double difference, double length) {
  const double turn = std::min(1.0, difference * length);
  return turn < kFlatTurn ? 0 : turn;
}

std::vector<CurvatureDirection> curvature_directions(const FormMesh& mesh, const std::vector<TangentFrame>& frames,
                                                     const std::vector<FormLink>& links, double length) {
  const std::vector<SecondForm> forms = second_forms(mesh, frames, evened_normals(mesh, links, kNormalPart * length));
  std::vector<CurvatureDirection> found(forms.size());
  for (std::uint32_t n = 0; n < found.size(); ++n) {
    const auto [e, f, g] = forms[n];
    const double difference = std::hypot(e - g, 2 * f), mean = e + g;  // k1 - k2, k1 + k2
    if (!(difference > 0)) continue;
    const double larger = std::atan2(2 * f, e - g) / 2;  // direction of the larger curvature, with sign
    found[n].first = mean >= 0 ? larger : larger + kQuarter;
    found[n].cross = std::polar(1.0, 4 * larger);
    found[n].weight = mesh.areas[n] * confidence_of(difference, length);
    found[n].first_weight = mesh.areas[n] * confidence_of(std::min(difference, std::abs(mean)), length);  // |k1| - |k2|
  }
  return found;
}

/// For each node, whether its first direction is a quarter turn beyond the angle of the cross (see step 3).
std::vector<char> first_directions(const std::vector<double>& angles, const std::vector<char>& known,
                                   const std::vector<CurvatureDirection>& found, const std::vector<FormLink>& links) {
  const std::size_t n = angles.size();
  std::vector<std::uint32_t> order(links.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto sureness = [&](std::uint32_t l) {
    return std::min(found[links[l].i].first_weight, found[links[l].j].first_weight);
  };
  parallel_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const double x = sureness(a), y = sureness(b);
    return x != y ? x > y : a < b;
  });
  DisjointSets trees(n);
  std::vector<std::vector<std::pair<std::uint32_t, char>>> branches(n);
  for (const std::uint32_t l : order) {
    const FormLink& link = links[l];
    if (!known[link.i] || !known[link.j] || trees.find(link.i) == trees.find(link.j)) continue;
    trees.join(link.i, link.j);
    const bool quarter = std::abs(std::cos(angles[link.i] - angles[link.j] - link.angle)) < std::sqrt(0.5);
    branches[link.i].emplace_back(link.j, quarter);
    branches[link.j].emplace_back(link.i, quarter);
  }
  std::vector<char> turned(n, 0), seen(n, 0);
  std::vector<std::uint32_t> tree;
  for (std::uint32_t root = 0; root < n; ++root) {
    if (seen[root]) continue;
    seen[root] = 1;
    tree.assign(1, root);
    double for_turn = 0;
    for (std::size_t k = 0; k < tree.size(); ++k) {
      const std::uint32_t at = tree[k];
      const double cosine = std::cos(found[at].first - angles[at]);
      for_turn += found[at].first_weight * (turned[at] ? -1 : 1) * (1 - 2 * cosine * cosine);
      for (const auto& [next, quarter] : branches[at]) {
        if (seen[next]) continue;
        seen[next] = 1;
        turned[next] = static_cast<char>(turned[at] ^ quarter);
        tree.push_back(next);
      }
    }
    if (for_turn > 0) {
      for (const std::uint32_t node : tree) turned[node] = static_cast<char>(!turned[node]);
    }
  }
  return turned;
}

/// The component of `v` in the plane, as a unit vector.
Point3 in_plane(const Point3& v, const Point3& normal) { return unit(v - normal * glm::dot(normal, v)); }

}  // namespace

FormField curvature_field(const FormMesh& mesh, double length, const std::function<Point3(std::uint32_t)>& otherwise) {
  const std::vector<TangentFrame> frames = tangent_frames(mesh);
  const std::vector<FormLink> links = form_links(mesh, frames);
  const std::vector<CurvatureDirection> found = curvature_directions(mesh, frames, links, length);
  std::vector<double> weights;
  std::vector<Complex> wanted;
  for (const CurvatureDirection& t : found) {
    weights.push_back(t.weight);
    wanted.push_back(t.cross);
  }
  const std::vector<Complex> crosses = evened(weights, wanted, links, length, 4);
  std::vector<double> angles(crosses.size());
  std::vector<char> known(crosses.size());
  for (std::uint32_t n = 0; n < angles.size(); ++n) {
    known[n] = std::abs(crosses[n]) > 0;
    angles[n] = std::arg(crosses[n]) / 4;
  }
  const std::vector<char> turned = first_directions(angles, known, found, links);
  for (std::size_t n = 0; n < angles.size(); ++n) wanted[n] = std::polar(1.0, 2 * (angles[n] + (turned[n] ? kQuarter : 0)));
  const std::vector<Complex> lines = evened(weights, wanted, links, length, 2);
  FormField::Directions directions(lines.size());
  for (std::uint32_t n = 0; n < directions.size(); ++n) {
    const bool is_known = std::abs(lines[n]) > 0;
    const double angle = std::arg(lines[n]) / 2;
    const Point3 along = is_known ? frames[n].x * std::cos(angle) + frames[n].y * std::sin(angle) : otherwise(n);
    directions[n] = {along, glm::cross(mesh.normals[n], along)};
  }
  return FormField(std::move(directions));
}

Point3 FormField::at(const FormMesh& mesh, std::uint32_t triangle, const Weights& weights, bool second) const {
  if (of_node_.empty()) {
    const Point3 normal = mesh.area_vector(triangle);
    const Point3 ways[] = {glm::cross(Point3{0, 1, 0}, normal), glm::cross(normal, Point3{1, 0, 0})};
    const Point3 way = unit(ways[second]);
    return way == Point3{0, 0, 0} ? unit(glm::cross(normal, ways[!second])) : way;  // the triangle lies in such a plane
  }
  const auto largest = std::max_element(weights.begin(), weights.end()) - weights.begin();
  const std::uint32_t node = mesh.triangles[triangle].node[static_cast<std::size_t>(largest)];
  bool same = second;
  return onward(mesh, triangle, weights, of_node_[node][second], same);
}

Point3 FormField::onward(const FormMesh& mesh, std::uint32_t triangle, const Weights& weights, const Point3& along,
                         bool& second) const {
  if (of_node_.empty()) {
    const Point3 ways[] = {at(mesh, triangle, weights, false), at(mesh, triangle, weights, true)};
    const double dots[] = {glm::dot(ways[0], along), glm::dot(ways[1], along)};
    second = std::abs(dots[1]) > std::abs(dots[0]);
    return dots[second] < 0 ? -ways[second] : ways[second];
  }
  Point3 sum{0, 0, 0};
  double for_second = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& ways = of_node_[mesh.triangles[triangle].node[k]];
    const double dots[] = {glm::dot(ways[0], along), glm::dot(ways[1], along)};
    const bool nearer = std::abs(dots[1]) > std::abs(dots[0]);
    sum += ways[nearer] * (weights[k] * (dots[nearer] < 0 ? -1 : 1));
    for_second += nearer ? weights[k] : -weights[k];
  }
  second = for_second > 0;
  return in_plane(sum, unit(mesh.area_vector(triangle)));
}

}  // namespace ligne
