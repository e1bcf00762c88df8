#include "order_check.hpp"

#include "drawing/measures.hpp"

namespace ligne::test {
namespace {

constexpr double kFromSidesMm = 0.002;
constexpr double kSameDepthMm = 0.0005;

struct Painted {
  std::uint32_t face;
  double depth;
};

/// The pieces painted at the point, the nearest first; false near a side, where nothing is to be asked.
bool painted_at(const PaintOrder& order, Point2 p, std::vector<Painted>& painted) {
  painted.clear();
  bool beside = false;
  for (auto piece = order.pieces.rbegin(); piece != order.pieces.rend(); ++piece) {
    beside |= is_near_side(*piece, p, kFromSidesMm);
    if (!holds(*piece, p)) continue;
    painted.push_back({piece->face, piece->plane[0] * p.x + piece->plane[1] * p.y + piece->plane[2]});
  }
  return !beside;
}

std::string fault_at(Point2 p, const std::vector<Painted>& painted, const std::vector<oracle::FaceHit>& hits) {
  const auto hit_of = [&](std::uint32_t face) {
    return std::find_if(hits.begin(), hits.end(), [&](const oracle::FaceHit& h) { return h.face == face; });
  };
  std::ostringstream out;
  for (std::size_t i = 0; i < painted.size(); ++i) {
    const auto hit = hit_of(painted[i].face);
    if (hit == hits.end()) {
      out << " face " << painted[i].face << " is not there;";
    } else if (std::abs(hit->depth_mm - painted[i].depth) > kSameDepthMm) {
      out << " face " << painted[i].face << " is at " << hit->depth_mm << ", not at " << painted[i].depth << ";";
    }
    if (i + 1 < painted.size() && painted[i].depth > painted[i + 1].depth + kSameDepthMm)
      out << " face " << painted[i].face << " is painted over face " << painted[i + 1].face << ";";
    for (std::size_t k = 0; k < i; ++k)
      if (painted[k].face == painted[i].face) out << " face " << painted[i].face << " is painted twice;";
  }
  for (const oracle::FaceHit& hit : hits) {
    // One of several faces that coincide stands for all.
    const bool there = std::any_of(painted.begin(), painted.end(), [&](const Painted& q) {
      return q.face == hit.face || std::abs(q.depth - hit.depth_mm) < kSameDepthMm;
    });
    if (!there) out << " face " << hit.face << " is not painted;";
  }
  if (out.str().empty()) return {};
  std::ostringstream head;
  head << "at " << p.x << ", " << p.y << ":" << out.str() << '\n';
  return head.str();
}

}  // namespace

OrderVerdict check_order(const PaintOrder& order, const oracle::Oracle& oracle, unsigned seed, int points) {
  OrderVerdict verdict;
  if (order.pieces.empty()) return verdict;
  std::mt19937 random(seed);
  std::vector<Painted> painted;
  for (int i = 0; i < points; ++i) {
    const auto& contour = order.pieces[random() % order.pieces.size()].contours.at(0);
    Rect box;
    for (const Point2& p : contour) box.extend(p);
    const Point2 p{std::uniform_real_distribution<double>(box.min.x, box.max.x)(random),
                   std::uniform_real_distribution<double>(box.min.y, box.max.y)(random)};
    if (!painted_at(order, p, painted) || oracle.distance_to_sides(p) < kFromSidesMm) continue;
    ++verdict.points;
    verdict.covered += painted.size() > 1;
    verdict.faults += fault_at(p, painted, oracle.faces_at(p));
  }
  return verdict;
}

}  // namespace ligne::test
