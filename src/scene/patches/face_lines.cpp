#include "scene/patches/face_lines.hpp"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include "scene/patches/fillets.hpp"

namespace ligne {
namespace {

using Side = std::pair<std::uint32_t, std::uint32_t>;  ///< two vertices in ascending order

/// A piece of the zero set: across a triangle, from one of its sides to another.
struct Piece {
  std::array<Side, 2> sides;
  std::array<Point3, 2> ends;
  std::uint32_t face;
};

struct PieceEnd {
  Side side;
  std::uint32_t piece;
  int end;
  friend bool operator<(const PieceEnd& l, const PieceEnd& r) {
    return std::tie(l.side, l.piece, l.end) < std::tie(r.side, r.piece, r.end);
  }
};

std::vector<Piece> pieces_of(const Scene& scene, const Topology& topology, std::span<const std::uint32_t> triangles,
                             const std::function<double(const Point3&)>& value) {
  std::vector<Piece> pieces;
  for (const std::uint32_t t : triangles) {
    const Triangle& triangle = topology.triangles[t];
    std::array<double, 3> at{};
    for (std::size_t k = 0; k < 3; ++k) at[k] = value(scene.vertices[triangle.v[k]]);
    Piece piece{{}, {}, triangle.face};
    int found = 0;
    for (std::size_t k = 0; k < 3 && found < 2; ++k) {
      const std::size_t next = (k + 1) % 3;
      if ((at[k] >= 0) == (at[next] >= 0)) continue;
      // From the lower vertex to the higher one, so that both triangles of a side find the same point.
      std::size_t from = k, to = next;
      if (triangle.v[from] > triangle.v[to]) std::swap(from, to);
      const double s = at[from] / (at[from] - at[to]);
      piece.sides[static_cast<std::size_t>(found)] = {triangle.v[from], triangle.v[to]};
      piece.ends[static_cast<std::size_t>(found)] =
          (1 - s) * scene.vertices[triangle.v[from]] + s * scene.vertices[triangle.v[to]];
      ++found;
    }
    if (found == 2) pieces.push_back(piece);
  }
  return pieces;
}

/// Adds the parts of a line where the function is not negative.
void add_kept(const FaceLine& line, const std::function<double(const Point3&)>& keeps, std::vector<FaceLine>& lines) {
  FaceLine part;
  const auto finish = [&] {
    if (!part.faces.empty()) lines.push_back(part);
    part = {};
  };
  for (std::size_t i = 0; i < line.faces.size(); ++i) {
    Point3 a = line.points[i], b = line.points[i + 1];
    const double at_a = keeps(a), at_b = keeps(b);
    if (at_a < 0 && at_b < 0) {
      finish();
      continue;
    }
    const Point3 cut = a + (b - a) * (at_a / (at_a - at_b));
    if (at_a < 0) a = cut;
    if (at_b < 0) b = cut;
    if (part.points.empty()) part.points.push_back(a);
    part.points.push_back(b);
    part.faces.push_back(line.faces[i]);
    if (at_b < 0) finish();
  }
  finish();
}

class Chainer {
 public:
  explicit Chainer(std::vector<Piece> pieces) : pieces_(std::move(pieces)), used_(pieces_.size(), 0) {
    for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
      for (int end = 0; end < 2; ++end) ends_.push_back({pieces_[i].sides[static_cast<std::size_t>(end)], i, end});
    }
    std::sort(ends_.begin(), ends_.end());
  }

  std::vector<FaceLine> run() {
    std::vector<FaceLine> lines;
    // Open lines come first, from their ends; the remaining lines are closed.
    for (const bool open : {true, false}) {
      for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
        for (int end = 0; end < 2; ++end) {
          if (used_[i] || (open && partner(i, end) != nullptr)) continue;
          lines.push_back(walk(i, end));
          lines.back().closed = !open;
        }
      }
    }
    return lines;
  }

 private:
  const Piece& piece(std::uint32_t i) const { return pieces_[i]; }

  /// The other piece at the side where a piece ends; null at the border of the triangles.
  const PieceEnd* partner(std::uint32_t i, int end) const {
    const Side& side = pieces_[i].sides[static_cast<std::size_t>(end)];
    auto at = std::lower_bound(ends_.begin(), ends_.end(), PieceEnd{side, 0, 0});
    for (; at != ends_.end() && at->side == side; ++at) {
      if (at->piece != i) return &*at;
    }
    return nullptr;
  }

  FaceLine walk(std::uint32_t i, int end) {
    FaceLine line;
    line.points.push_back(piece(i).ends[static_cast<std::size_t>(end)]);
    while (true) {
      used_[i] = 1;
      line.points.push_back(piece(i).ends[static_cast<std::size_t>(1 - end)]);
      line.faces.push_back(piece(i).face);
      const PieceEnd* next = partner(i, 1 - end);
      if (!next || used_[next->piece]) return line;
      i = next->piece;
      end = next->end;
    }
  }

  std::vector<Piece> pieces_;
  std::vector<std::uint8_t> used_;
  std::vector<PieceEnd> ends_;
};

}  // namespace

void add_zero_lines(const Scene& scene, const Topology& topology, std::span<const std::uint32_t> triangles,
                    const std::function<double(const Point3&)>& value, const std::function<double(const Point3&)>& keeps,
                    std::vector<FaceLine>& lines) {
  for (const FaceLine& line : Chainer(pieces_of(scene, topology, triangles, value)).run()) {
    if (keeps) {
      add_kept(line, keeps, lines);
    } else {
      lines.push_back(line);
    }
  }
}

}  // namespace ligne
