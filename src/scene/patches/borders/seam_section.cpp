#include "scene/patches/borders/seam_section.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/no_index.hpp"
#include "geometry/small_matrices.hpp"
#include "scene/model/faces_and_edges.hpp"

namespace ligne {
namespace {

// Adjustable.
/// Faces up to kSectionRings edges away count, kMostSectionFaces at most, whose normals differ from the first one by 45
/// degrees at most. Faces of more than kMostSectionCorners are not passed.
constexpr int kSectionRings = 2;
constexpr std::size_t kMostSectionFaces = 40, kMostSectionCorners = 8;
constexpr double kLeastSectionCosine = 0.7;
/// Vertices count up to so many depths of the first face away from the edge, and up to one edge length and one depth beyond
/// its ends.
constexpr double kSectionDepths = 2.6, kSectionLengths = 1.5;
/// Number of coefficients of the quadric: those of the tangent plane, its turn along the edge, and two curvatures.
constexpr std::size_t kSectionCoefficients = 7;
/// Keeps the matrix regular where the vertices do not determine all coefficients, as a part of the diagonal and in all.
constexpr double kSectionDamping = 1e-9, kLeastSectionDamping = 1e-12;

using SectionRow = std::array<double, kSectionCoefficients>;

SectionRow coefficients(const Point3& place) {
  const double s = place.x, t = place.y, square = s * s / 2;
  return {1, s, t, s * t, t * t / 2, s < 0 ? square : 0, s < 0 ? 0 : square};
}

/// The quadric of least squares through places in units of the size of the section.
std::optional<SectionRow> fit(std::span<const Point3> places) {
  std::array<SectionRow, kSectionCoefficients> matrix{};
  SectionRow x{};
  for (const Point3& place : places) {
    const SectionRow row = coefficients(place);
    for (std::size_t i = 0; i < kSectionCoefficients; ++i) {
      for (std::size_t j = 0; j <= i; ++j) matrix[i][j] += row[i] * row[j];
      x[i] += row[i] * place.z;
    }
  }
  for (std::size_t i = 0; i < kSectionCoefficients; ++i)
    matrix[i][i] = matrix[i][i] * (1 + kSectionDamping) + kLeastSectionDamping;
  if (!solve_symmetric(matrix, x)) return std::nullopt;
  return x;
}

double error_of(const SectionRow& quadric, std::span<const Point3> places) {
  double squares = 0;
  for (const Point3& place : places) {
    const SectionRow row = coefficients(place);
    double off = -place.z;
    for (std::size_t i = 0; i < kSectionCoefficients; ++i) off += quadric[i] * row[i];
    squares += off * off;
  }
  return std::sqrt(squares / static_cast<double>(places.size()));
}

// Adjustable.
/// Least part of the length of a line that has sections, and least part of that at which these agree.
constexpr double kMostMeasured = 0.6, kMostAgreeing = 0.6;
/// Least value of both for a line of few edges.
constexpr double kWholeLine = 0.99;
/// Largest curvature of the flat side where a section agrees, in that of the round one.
constexpr double kAgreeingRatio = 0.5;
/// Limits of the ratio of the curvatures, which is negative at an inflection.
constexpr double kLeastSeamRatio = -0.6, kLargestSeamRatio = 0.4;
/// Limits of the turn of the round side over a face, radians, and of the error.
constexpr double kLeastLineTurn = 0.03, kLargestLineTurn = 1.3, kLargestLineError = 0.3;
/// Least ratio of the depths, and least one of a line of few edges.
constexpr double kLeastLineDepths = 0.8, kLeastDepthsOfFew = 1.5;
constexpr std::size_t kFewLineEdges = 3;
/// Limits of a line one of whose sides is nearly flat.
constexpr double kClearRatio = 0.15, kLeastClearTurn = 0.1, kLargestClearError = 0.1, kMostClearAgreeing = 0.8;
/// Least ratio of curvatures where both sides bend alike.
constexpr double kEvenRatio = 0.6;

/// A value with the length of the line that it stands for.
using Weighted = std::pair<double, double>;

double median(std::vector<Weighted> values) {
  double all = 0, sum = 0;
  for (const Weighted& value : values) all += value.second;
  std::ranges::sort(values);
  for (const auto& [number, weight] : values) {
    sum += weight;
    if (2 * sum >= all) return number;
  }
  return 0;
}

template <class Value>
double median_of(std::span<const LineSection> sections, Value value) {
  std::vector<Weighted> values;
  for (const LineSection& at : sections) {
    if (at.section) values.emplace_back(value(*at.section), at.length);
  }
  return median(std::move(values));
}

}  // namespace

std::optional<SeamSections::Frame> SeamSections::frame_at(const Edge& edge) const {
  const Point3 &from = scene_.vertices[edge.v0], &to = scene_.vertices[edge.v1];
  Frame frame{(from + to) * 0.5, to - from, {}, {}, glm::distance(from, to)};
  const Point3 mean = face_normal(scene_, edge.face0) + face_normal(scene_, edge.face1),
               across = glm::cross(mean, frame.along);
  if (!(glm::dot(across, across) > 0)) return std::nullopt;
  frame.along /= frame.length;
  frame.across = glm::normalize(across);
  frame.normal = glm::cross(frame.along, frame.across);
  return frame;
}

/// Distance of the corner of a face that is farthest from the edge, with its sign.
double SeamSections::depth(std::uint32_t face, const Frame& frame) const {
  double depth = 0;
  for (const std::uint32_t v : scene_.faces.contour(face, 0)) {
    const double s = frame.place(scene_.vertices[v]).x;
    if (std::abs(s) > std::abs(depth)) depth = s;
  }
  return depth;
}

/// Adds the places of the vertices near an edge, on the side of a face whose depth() is given, but for those of the edge.
void SeamSections::add_places(std::uint32_t e, std::uint32_t face, double depth, const Frame& frame,
                              std::vector<Point3>& places) const {
  const Edge& edge = topology_.edges[e];
  std::vector<std::uint32_t> faces{face}, seen{edge.v0, edge.v1};
  const Point3 normal = face_normal(scene_, face);
  std::size_t next = 0;
  for (int ring = 0; ring <= kSectionRings; ++ring) {
    for (const std::size_t last = faces.size(); next < last; ++next) {
      const auto contour = scene_.faces.contour(faces[next], 0);
      for (const std::uint32_t v : contour) {
        if (std::ranges::find(seen, v) != seen.end()) continue;
        seen.push_back(v);
        const Point3 place = frame.place(scene_.vertices[v]);
        const double away = depth < 0 ? -place.x : place.x, size = std::abs(depth);
        if (away < 0 || away > kSectionDepths * size || std::abs(place.y) > kSectionLengths * frame.length + size) continue;
        places.push_back(place);
      }
      if (ring == kSectionRings || contour.size() > kMostSectionCorners) continue;
      for (std::size_t k = 0; k < contour.size() && faces.size() < kMostSectionFaces; ++k) {
        const std::uint32_t side = edge_between(topology_, contour[k], contour[k + 1 == contour.size() ? 0 : k + 1]);
        if (side == kNone || side == e || !is_inner_[side]) continue;
        const std::uint32_t other = other_face(topology_.edges[side], faces[next]);
        if (std::ranges::find(faces, other) != faces.end()) continue;
        if (glm::dot(face_normal(scene_, other), normal) < kLeastSectionCosine) continue;
        faces.push_back(other);
      }
    }
  }
}

std::optional<SeamSection> SeamSections::at(std::uint32_t e) const {
  const Edge& edge = topology_.edges[e];
  const std::optional<Frame> frame = frame_at(edge);
  if (!frame) return std::nullopt;
  const std::array depths{depth(edge.face0, *frame), depth(edge.face1, *frame)};
  if (!(depths[0] * depths[1] < 0)) return std::nullopt;
  std::vector<Point3> places{{0, frame->length / 2, 0}, {0, -frame->length / 2, 0}};
  add_places(e, edge.face0, depths[0], *frame, places);
  add_places(e, edge.face1, depths[1], *frame, places);
  if (places.size() <= kSectionCoefficients) return std::nullopt;
  const double size = std::max({frame->length, std::abs(depths[0]), std::abs(depths[1])});
  for (Point3& place : places) place /= size;
  const std::optional<SectionRow> quadric = fit(places);
  if (!quadric) return std::nullopt;
  // The last coefficients are the curvatures before and behind the edge.
  const std::size_t first = depths[0] < 0 ? 5 : 6;
  SeamSection section{.curvatures = {(*quadric)[first] / size, (*quadric)[11 - first] / size},
                      .depths = {std::abs(depths[0]), std::abs(depths[1])},
                      .error = error_of(*quadric, places) * size};
  if (section.curvatures[section.round_side()] == 0) return std::nullopt;
  return section;
}

double roughness(const Scene& scene, std::span<const std::uint32_t> vertices) {
  double sum = 0;
  for (std::size_t i = 2; i + 2 < vertices.size(); ++i) {
    std::array<double, 5> at{};
    for (std::size_t k = 1; k < 5; ++k)
      at[k] = at[k - 1] + glm::distance(scene.vertices[vertices[i + k - 2]], scene.vertices[vertices[i + k - 3]]);
    Point3 smooth(0, 0, 0);
    for (const std::size_t k : {0, 1, 3, 4}) {
      double weight = 1;
      for (const std::size_t other : {0, 1, 3, 4})
        if (other != k) weight *= (at[2] - at[other]) / (at[k] - at[other]);
      smooth += weight * scene.vertices[vertices[i + k - 2]];
    }
    sum += glm::distance(smooth, scene.vertices[vertices[i]]) / std::min(at[2] - at[1], at[3] - at[2]);
  }
  return sum / static_cast<double>(vertices.size() - 4);
}

bool LineBend::may_be_seam() const {
  const double least_depths = edges > kFewLineEdges ? kLeastLineDepths : kLeastDepthsOfFew;
  return measured >= kMostMeasured && agreeing >= kMostAgreeing && ratio > kLeastSeamRatio && ratio < kLargestSeamRatio &&
         turn > kLeastLineTurn && turn < kLargestLineTurn && depths >= least_depths && error <= kLargestLineError;
}

bool LineBend::is_clear() const {
  return std::abs(ratio) <= kClearRatio && turn >= kLeastClearTurn && error <= kLargestClearError &&
         agreeing >= kMostClearAgreeing;
}

bool LineBend::is_even() const { return measured > 0 && (std::abs(ratio) > kEvenRatio || turn < kLeastLineTurn); }

bool LineBend::is_whole() const { return measured >= kWholeLine && agreeing >= kWholeLine; }

LineBend bend_along(std::span<const LineSection> sections) {
  LineBend bend;
  bend.edges = sections.size();
  for (const LineSection& at : sections) {
    bend.length += at.length;
    if (at.section) bend.measured += at.length;
  }
  if (bend.measured == 0) return bend;
  std::array<double, 2> medians{};
  for (const std::size_t side : {0, 1})
    medians[side] = median_of(sections, [&](const SeamSection& at) { return at.curvatures[side]; });
  const std::size_t round = std::abs(medians[0]) > std::abs(medians[1]) ? 0 : 1, flat = 1 - round;
  if (medians[round] == 0) return bend;
  for (const LineSection& at : sections) {
    if (!at.section) continue;
    const std::array<double, 2>& curvatures = at.section->curvatures;
    const bool is_usual = curvatures[round] * medians[round] > 0;
    if (is_usual && std::abs(curvatures[flat]) < kAgreeingRatio * std::abs(curvatures[round])) bend.agreeing += at.length;
  }
  bend.agreeing /= bend.measured;
  bend.measured /= bend.length;
  bend.ratio = medians[flat] / medians[round];
  bend.turn = median_of(sections, [&](const SeamSection& at) { return at.turn(round); });
  bend.depth = median_of(sections, [&](const SeamSection& at) { return at.depths[round]; });
  bend.depths = median_of(sections, [&](const SeamSection& at) { return at.depths[flat] / at.depths[round]; });
  bend.error = median_of(sections, [&](const SeamSection& at) {
    const double sags = at.turn(round) * at.depths[round];
    return sags > 0 ? at.error / sags : std::numeric_limits<double>::infinity();
  });
  return bend;
}

}  // namespace ligne
