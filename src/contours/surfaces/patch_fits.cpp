#include <array>
#include <span>
#include <utility>

#include <glm/geometric.hpp>

#include "base/indices_where.hpp"
#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "base/uninitialized_vector.hpp"
#include "contours/surfaces/known_surfaces.hpp"
#include "contours/surfaces/smooth_patch.hpp"

namespace ligne {
namespace {

constexpr std::size_t kSectorsPerTask = 512;
constexpr int kRings = 2;

/// Per sector: its corners, its position, the directions that its faces face, and the sectors at the other corners of
/// its triangles.
class Sectors {
 public:
  Sectors(const Scene& scene, const SmoothPatch& patch)
      : begin_(patch.normals.size() + 1, 0),
        corners_(patch.sector.size()),
        others_(patch.sector.size()),
        places_(patch.normals.size()),
        ways_(patch.normals.size(), 0) {
    parallel_tasks(patch.runs.size(), [&](std::size_t r) { add(scene, patch, patch.runs[r]); });
  }
  std::span<const std::uint32_t> corners(std::uint32_t sector) const {
    return {corners_.data() + begin_[sector], corners_.data() + begin_[sector + 1]};
  }
  /// The two other corners of the triangle at each corner of the sector.
  std::span<const std::array<std::uint32_t, 2>> others(std::uint32_t sector) const {
    return {others_.data() + begin_[sector], others_.data() + begin_[sector + 1]};
  }
  const Point3& place(std::uint32_t sector) const { return places_[sector]; }
  /// Whether any face of the sector faces the viewer (`towards`), or faces away.
  bool any_faces(std::uint32_t sector, bool towards) const { return (ways_[sector] & way(towards)) != 0; }

 private:
  static std::uint8_t way(bool towards) { return towards ? 1 : 2; }

  /// Adds the sectors of a run. It does not touch the sectors of other runs, so threads can add runs in parallel.
  void add(const Scene& scene, const SmoothPatch& patch, const SmoothPatch::Run& run) {
    const std::uint32_t first = 3 * run.triangle, last = 3 * run.triangle_end;
    for (std::uint32_t c = first; c < last; ++c) ++begin_[patch.sector[c] + 1];
    std::vector<std::uint32_t> next(run.sector_end - run.sector);
    std::uint32_t begin = first;
    for (std::uint32_t s = run.sector; s < run.sector_end; ++s) {
      next[s - run.sector] = begin;
      begin += begin_[s + 1];
      begin_[s + 1] = begin;
    }
    for (std::uint32_t c = first; c < last; ++c) {
      const std::uint32_t s = patch.sector[c], at = next[s - run.sector]++;
      corners_[at] = c;
      others_[at] = {patch.sector[next_corner(c)], patch.sector[previous_corner(c)]};
      if (ways_[s] == 0) places_[s] = scene.vertices[patch.triangles[c / 3].v[c % 3]];
      ways_[s] |= way(patch.facing[c / 3] >= 0);
    }
  }

  std::vector<std::uint32_t> begin_;
  UninitializedVector<std::uint32_t> corners_;
  UninitializedVector<std::array<std::uint32_t, 2>> others_;
  UninitializedVector<Point3> places_;
  std::vector<std::uint8_t> ways_;
};

class PatchFits {
 public:
  PatchFits(const Scene& scene, const Camera& camera, SmoothPatch& patch)
      : scene_(scene), camera_(camera), patch_(patch), sectors_(scene, patch), reached_from_(thread_count()) {
    patch_.fit.assign(patch_.normals.size(), kNone);
  }

  /// Fits first the sectors whose faces face both ways, since only these may change their labels; then the other ends
  /// of the sides that the zero set of g crosses.
  void fit_all() {
    std::vector<std::uint32_t> first, then;
    std::vector<std::uint8_t> taken(patch_.normals.size(), 0);
    for (std::uint32_t s = 0; s < taken.size(); ++s) {
      if (!sectors_.any_faces(s, true) || !sectors_.any_faces(s, false)) continue;
      taken[s] = 1;
      first.push_back(s);
    }
    fit(first);
    const auto is_crossed = [&](std::size_t c) {
      const auto corner = static_cast<std::uint32_t>(c);
      return patch_.looks_at_viewer(corner) != patch_.looks_at_viewer(next_corner(corner));
    };
    for (const std::uint32_t c : indices_where(patch_.sector.size(), is_crossed)) {
      for (const std::uint32_t s : {patch_.sector[c], patch_.sector[next_corner(c)]}) {
        if (!std::exchange(taken[s], 1)) then.push_back(s);
      }
    }
    fit(then);
  }

 private:
  void fit(const std::vector<std::uint32_t>& sectors) {
    const auto first_turn = static_cast<std::uint32_t>(patch_.turns.size());
    patch_.turns.resize(first_turn + sectors.size());
    parallel_blocks(sectors.size(), kSectorsPerTask, [&](std::size_t begin, std::size_t end) {
      // Each sector is fitted once, so marks that a thread left for other sectors never match.
      std::vector<std::uint32_t>& reached_from = reached_from_[thread_index()];
      reached_from.resize(patch_.normals.size(), kNone);
      std::vector<std::uint32_t> reached;
      std::array<std::uint32_t, 2> pair;
      std::array<std::vector<Point3>, 2> points;
      std::size_t count = 0;
      const auto fit_pair = [&] {
        std::array<PointsRound, 2> rounds;
        for (std::size_t f = 0; f < count; ++f) {
          const std::uint32_t s = sectors[pair[f]];
          rounds[f] = {sectors_.place(s), patch_.normals[s], points[f]};
        }
        const auto fits = fit_two_surfaces(rounds);
        for (std::size_t f = 0; f < count; ++f) {
          if (fits[f]) take(sectors[pair[f]], first_turn + pair[f], *fits[f]);
        }
        count = 0;
      };
      for (std::size_t i = begin; i < end; ++i) {
        const std::uint32_t s = sectors[i];
        if (take_known(s, first_turn + static_cast<std::uint32_t>(i))) continue;
        if (!patch_.complete[sectors_.corners(s)[0]] || patch_.normals[s] == Point3(0.0) || patch_.ruled[s]) continue;
        reach_rings(s, reached, reached_from);
        pair[count] = static_cast<std::uint32_t>(i);
        points[count].clear();
        for (std::size_t k = 1; k < reached.size(); ++k) points[count].push_back(sectors_.place(reached[k]));
        if (++count == pair.size()) fit_pair();
      }
      if (count > 0) fit_pair();
    });
  }

  /// Takes the normal of the surfaces recognised behind the faces of a sector. Returns true if all faces have one
  /// surface, which also gives the derivative of the normal. Where several surfaces meet, their common normal is the
  /// starting value of a fit.
  bool take_known(std::uint32_t s, std::uint32_t turn) {
    if (!patch_.surfaces) return false;
    const auto known = known_normal(scene_, patch_, sectors_.corners(s));
    if (!known) return false;
    const double g = glm::dot(known->normal, to_eye(camera_, sectors_.place(s)));
    if (!sectors_.any_faces(s, g >= 0)) return known->turn.has_value();
    patch_.normals[s] = known->normal;
    patch_.g[s] = g;
    if (!known->turn) return false;
    patch_.turns[turn] = *known->turn;
    patch_.fit[s] = turn;
    return true;
  }

  /// Stores a fit, unless no face of the sector faces the same way. `turn`: index of its derivative in
  /// SmoothPatch::turns.
  void take(std::uint32_t s, std::uint32_t turn, const SurfaceFit& fit) {
    const double g = glm::dot(fit.normal, to_eye(camera_, sectors_.place(s)));
    if (!sectors_.any_faces(s, g >= 0)) return;
    patch_.normals[s] = fit.normal;
    patch_.turns[turn] = fit.turn;
    patch_.g[s] = g;
    patch_.fit[s] = turn;
  }

  /// Lists the sector and the sectors within kRings rings of triangles. `reached_from`: per sector, the start of the
  /// search that reached it last.
  void reach_rings(std::uint32_t sector, std::vector<std::uint32_t>& reached,
                   std::vector<std::uint32_t>& reached_from) const {
    reached.assign(1, sector);
    reached_from[sector] = sector;
    std::size_t next = 0;
    for (int ring = 0; ring < kRings; ++ring) {
      for (const std::size_t last = reached.size(); next < last; ++next) {
        for (const auto& others : sectors_.others(reached[next])) {
          for (const std::uint32_t other : others) {
            if (std::exchange(reached_from[other], sector) != sector) reached.push_back(other);
          }
        }
      }
    }
  }

  const Scene& scene_;
  const Camera& camera_;
  SmoothPatch& patch_;
  Sectors sectors_;
  std::vector<std::vector<std::uint32_t>> reached_from_;  ///< per thread and sector: see reach_rings()
};

}  // namespace

void fit_surfaces(const Scene& scene, const Camera& camera, SmoothPatch& patch) {
  PatchFits(scene, camera, patch).fit_all();
}

}  // namespace ligne
