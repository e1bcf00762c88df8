/// Evenly spaced strokes ([Jobard1997]) in octaves of distance:
///
/// 1. Strokes at the distance D are placed wherever a distance of at least D/2 is wanted, and continue where strokes
///    should be closer. Then strokes at half the distance are placed between them, where they are wanted. So strokes
///    end one by one towards the light.
/// 2. A stroke begins at the wanted distance beside an existing one, or anywhere if there is none. It follows the field
///    in both directions until it meets a rim, the light, or another stroke of its direction.
/// 3. Between two octaves, some strokes of the denser one are drawn. A number decides how far each of them goes;
///    strokes that begin on the same side of the same stroke share it.
///
/// Distances are measured on the page between points of one sheet of the surface: each lies near the tangent plane of
/// the other.

#include "picture/hatching/form_strokes.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <unordered_map>

#include <glm/geometric.hpp>

#include "base/hash.hpp"
#include "base/stop.hpp"
#include "geometry/simplify.hpp"

namespace ligne {
namespace {

// Adjustable, in distances of the strokes.
constexpr double kBeginApart = 0.9;  ///< least distance of a stroke's begin from other strokes
constexpr double kStayApart = 0.65;  ///< distance at which a stroke ends
constexpr double kSeedsEvery = 0.5;  ///< distance along a stroke at which others may begin beside it
/// Least length of a stroke between two rims, from one rim, and free, in closest distances. The last is in its own
/// distance.
constexpr double kShortest[] = {1, 2, 4};
constexpr double kShortestOwn = 1.2;
constexpr double kAlike = 0.7;  ///< cosine: strokes at larger angles cross
/// Largest distance of a removed point from the line, in mm: less than half a step of a plotter.
constexpr double kFlatnessMm = 0.01;

/// A point of a stroke.
struct Sample {
  FormPlace place;
  Point3 at, along, normal;
  double length;  ///< along the stroke from its begin; negative on its other side
  double scale;   ///< page mm per unit of model
  std::uint32_t stroke, surface;
  FormTone tone;
};

struct PlacedStroke {
  std::vector<Sample> samples;
  bool second = false;
};

/// A number in [0, 1) for each key (the finalizer of SplitMix64).
double share_of(std::uint64_t key) { return static_cast<double>(mix_bits(key + kGoldenRatio) >> 11) * 0x1p-53; }

class StrokePlacement {
 public:
  StrokePlacement(const FormGround& ground, const std::function<FormTone(const FormPlace&)>& tone,
                  const FormStrokeOptions& options)
      : mesh_(ground.mesh),
        field_(ground.field),
        walk_(ground.walk),
        regions_(ground.regions),
        surfaces_(ground.surfaces),
        tone_(tone),
        options_(options) {}

  void add(bool second, double distance_mm, std::span<const FormPlace> begins);
  std::vector<FormStroke> take() const;

 private:
  /// Makes a sample of the current stroke.
  Sample sample(const FormPlace& place, const Point3& along, double length) const;
  bool allowed(const Sample& sample, bool second) const;
  /// Whether another stroke of this direction is nearer; sets `own` if it is the stroke itself.
  bool crowded(const Sample& sample, double distance_mm, const Sample** own) const;
  bool begin_at(const FormPlace& place, double share);
  enum class End { rim, free, closed };
  End trace(std::vector<Sample>& line, Point3 along, double sign);
  void begin_beside(std::uint32_t stroke);
  void file(const Sample& sample);
  void withdraw(const Sample& sample);
  std::uint64_t cell_of(Point2 page, int dx = 0, int dy = 0) const;

  const FormMesh& mesh_;
  const FormField& field_;
  const FormWalk& walk_;
  const FormRegions& regions_;
  std::span<const std::uint32_t> surfaces_;
  const std::function<FormTone(const FormPlace&)>& tone_;
  const FormStrokeOptions& options_;
  std::vector<PlacedStroke> strokes_;
  std::unordered_map<std::uint64_t, std::vector<Sample>> cells_;
  double points_ = 0;
  // For the strokes that are added now:
  bool second_ = false;
  double distance_ = 0;
  double limit_ = 0;  ///< a stroke ends where the wanted distance is at least this
};

std::uint64_t StrokePlacement::cell_of(Point2 page, int dx, int dy) const {
  const double size = options_.closest_mm;
  return grid_cell(static_cast<std::int32_t>(std::floor(page.x / size)) + dx,
                   static_cast<std::int32_t>(std::floor(page.y / size)) + dy);
}

void StrokePlacement::file(const Sample& sample) {
  if (++points_ > options_.most_points) throw std::length_error("too many points");
  cells_[cell_of(sample.place.page)].push_back(sample);
}

/// Removes the sample, which must be the last one in its cell.
void StrokePlacement::withdraw(const Sample& sample) {
  --points_;
  cells_[cell_of(sample.place.page)].pop_back();
}

Sample StrokePlacement::sample(const FormPlace& place, const Point3& along, double length) const {
  const FormTriangle& triangle = mesh_.triangles[place.triangle];
  Point3 normal{0, 0, 0};
  for (std::size_t k = 0; k < 3; ++k) normal += mesh_.normals[triangle.node[k]] * place.weights[k];
  const double size = glm::length(normal);
  const Point3 at = walk_.point(place);
  return {place,
          at,
          along,
          size > 0 ? normal / size : normal,
          length,
          walk_.scale_at(at),
          static_cast<std::uint32_t>(strokes_.size()),
          surfaces_[triangle.face],
          tone_(place)};
}

bool StrokePlacement::allowed(const Sample& sample, bool second) const {
  return sample.tone.spacing_mm[second] < limit_ && !regions_.near_rim(sample.place.page, sample.tone.pen_mm / 2);
}

bool StrokePlacement::crowded(const Sample& sample, double distance_mm, const Sample** own) const {
  const auto reach = static_cast<int>(std::ceil(distance_mm / options_.closest_mm));
  for (int dx = -reach; dx <= reach; ++dx) {
    for (int dy = -reach; dy <= reach; ++dy) {
      const auto found = cells_.find(cell_of(sample.place.page, dx, dy));
      if (found == cells_.end()) continue;
      for (const Sample& other : found->second) {
        if (glm::distance(other.place.page, sample.place.page) >= distance_mm || other.surface != sample.surface) continue;
        if (std::abs(glm::dot(other.along, sample.along)) < kAlike) continue;
        const Point3 way = other.at - sample.at;
        const double beside = std::max(std::abs(glm::dot(way, sample.normal)), std::abs(glm::dot(way, other.normal)));
        if (beside * sample.scale >= distance_mm) continue;  // another sheet
        if (other.stroke == sample.stroke) {
          if (std::abs(other.length - sample.length) < 3 * distance_mm) continue;
          if (own) *own = &other;
        }
        return true;
      }
    }
  }
  return false;
}

/// Appends points until the stroke ends. It is `closed` if it returned to its begin, which is then also its last point.
StrokePlacement::End StrokePlacement::trace(std::vector<Sample>& line, Point3 along, double sign) {
  FormPlace place = line.front().place;
  bool second = second_, closing = false;
  double length = 0, last = 0;
  const double step = kFormStep * options_.closest_mm, apart = kStayApart * distance_;
  const Sample first = line.front();
  for (;;) {
    check_stop();
    const Point2 before = place.page;
    if (!walk_.step(field_, place, along, second, step)) return End::rim;
    length += glm::distance(before, place.page);
    if (closing && glm::distance(place.page, first.place.page) <= 2 * step) {
      line.push_back(first);
      return End::closed;
    }
    if (length - last < step / 2) continue;  // skips steps over small triangles
    last = length;
    const Sample next = sample(place, along * sign, sign * length);
    if (!allowed(next, second)) return next.tone.spacing_mm[second] < limit_ ? End::rim : End::free;
    const Sample* own = nullptr;
    if (crowded(next, apart, &own)) {
      if (!own) return End::free;
      const Point2 way = first.place.page - place.page;
      const Point2 ahead = place.page - before;
      const double aside = std::abs(way.x * ahead.y - way.y * ahead.x) / std::max(glm::length(ahead), step / 2);
      closing = closing || (glm::length(way) < 2 * apart && glm::dot(way, ahead) > 0 && aside < apart / 2);
      if (!closing || glm::length(way) > 3 * apart) return End::free;
    }
    line.push_back(next);
    file(next);
  }
}

bool StrokePlacement::begin_at(const FormPlace& place, double share) {
  limit_ = distance_ < kSparsest * options_.closest_mm ? 2 * distance_ / (1 + share) : FormTone::kNoStrokes;
  const Point3 along = field_.at(mesh_, place.triangle, place.weights, second_);
  if (along == Point3{0, 0, 0}) return false;
  const Sample first = sample(place, along, 0);
  if (!allowed(first, second_) || crowded(first, kBeginApart * distance_, nullptr)) return false;
  std::vector<Sample> onward{first}, back{first};
  file(first);
  const End end = trace(onward, along, 1);
  const bool closed = end == End::closed;
  const int free_ends = closed ? 0 : (end == End::free) + (trace(back, -along, -1) == End::free);
  PlacedStroke stroke{{back.rbegin(), back.rend() - 1}, second_};
  stroke.samples.insert(stroke.samples.end(), onward.begin(), onward.end());
  double length = 0;
  for (std::size_t i = 1; i < stroke.samples.size(); ++i) {
    length += glm::distance(stroke.samples[i - 1].place.page, stroke.samples[i].place.page);
  }
  const double shortest = std::max(kShortest[free_ends] * options_.closest_mm, free_ends > 0 ? kShortestOwn * distance_ : 0);
  if (length < std::max(options_.shortest_mm, shortest)) {
    for (std::size_t i = back.size(); i > 1; --i) withdraw(back[i - 1]);
    for (std::size_t i = onward.size(); i > 0; --i) {
      if (i == 1 || i < onward.size() || !closed) withdraw(onward[i - 1]);
    }
    return false;
  }
  strokes_.push_back(std::move(stroke));
  return true;
}

void StrokePlacement::begin_beside(std::uint32_t stroke) {
  double next = 0, length = 0;
  for (std::size_t i = 0; i + 1 < strokes_[stroke].samples.size(); ++i) {
    const FormPlace place = strokes_[stroke].samples[i].place;  // by value: strokes are added
    const Point2 way = strokes_[stroke].samples[i + 1].place.page - place.page;
    const double size = glm::length(way);
    length += size;
    if (length < next || !(size > 0)) continue;
    next = length + kSeedsEvery * distance_;
    for (const int side : {1, -1}) {
      FormPlace beside = place;
      if (!walk_.cross(beside, Point2{-way.y, way.x} * (side / size), distance_)) continue;
      begin_at(beside, share_of(2 * std::uint64_t{stroke} + (side > 0)));
    }
  }
}

void StrokePlacement::add(bool second, double distance_mm, std::span<const FormPlace> begins) {
  second_ = second;
  distance_ = distance_mm;
  std::uint32_t next = 0;
  const auto spread = [&] {
    for (; next < strokes_.size(); ++next) {
      if (strokes_[next].second == second_) begin_beside(next);
    }
  };
  spread();
  for (std::size_t i = 0; i < begins.size(); ++i) {
    if (begin_at(begins[i], share_of(~std::uint64_t{i}))) spread();
  }
}

std::vector<FormStroke> StrokePlacement::take() const {
  std::vector<FormStroke> result;
  for (const PlacedStroke& stroke : strokes_) {
    const std::vector<Sample>& samples = stroke.samples;
    for (std::size_t from = 0; from + 1 < samples.size();) {
      std::size_t to = from + 1;  // the last point of this layer's part
      const std::uint32_t layer = samples[from].tone.layer;
      while (to + 1 < samples.size() && samples[to].tone.layer == layer) ++to;
      std::vector<Point2> line;
      double length = 0;
      for (std::size_t i = from; i <= to; ++i) {
        line.push_back(samples[i].place.page);
        if (i > from) length += glm::distance(line[line.size() - 2], line.back());
      }
      from = to;
      if (length < options_.shortest_mm) continue;
      FormStroke& out = result.emplace_back(FormStroke{layer, {}});
      for (const std::uint32_t i : simplified(line, kFlatnessMm)) out.points.push_back(line[i]);
    }
  }
  return result;
}

}  // namespace

std::vector<FormStroke> form_strokes(const FormGround& ground, std::span<const Region> seen,
                                     const std::function<FormTone(const FormPlace&)>& tone,
                                     const FormStrokeOptions& options) {
  StrokePlacement placement(ground, tone, options);
  std::vector<FormPlace> begins;
  for (const Region& region : seen) {
    const std::optional<Point2> inside = region.level == 0 ? FormRegions::point_inside(region) : std::nullopt;
    if (!inside) continue;
    if (const auto place = ground.walk.place_on(region.face, *inside)) begins.push_back(*place);
  }
  for (const bool second : {false, true}) {
    for (double distance = kSparsest; distance >= 1; distance /= 2) {
      placement.add(second, distance * options.closest_mm, begins);
    }
  }
  return placement.take();
}

}  // namespace ligne
