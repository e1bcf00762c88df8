#include "visibility/horizon/part_edges.hpp"

#include <utility>

#include "base/parallel.hpp"

namespace ligne::horizon {
namespace {

/// Samples that all threads read at a time, and limits on the number of rows that hold them: enough rows for every
/// thread.
constexpr std::size_t kSamplesAtATime = std::size_t{1} << 13, kFewestRows = 8, kMostRows = 256;
/// Rows of the previous block that the first strip of a block needs.
constexpr std::size_t kCarried = 2;

}  // namespace

PartEdges::PartEdges(const GridPart& grid, const View& view, const HorizonOptions& options, const Eye& eye,
                     const Bands& bands, bool covers)
    : grid_(grid),
      view_(view),
      options_(options),
      eye_(eye),
      bands_(bands),
      covers_(covers),
      anti_(grid.columns.sign == grid.rows.sign),
      picture_(view.camera.perspective ? 0 : bands.columns().extent()),
      upright_(kUprightPart * bands.columns().extent()),
      column_curves_(grid.columns.order.size()),
      no_cells_(grid.columns.order.size()) {
  for (const double level : options.contours) levels_.push_back(level * options.z_scale);
  const std::size_t count = std::clamp(kSamplesAtATime / grid.columns.order.size(), kFewestRows, kMostRows);
  rows_.resize(kCarried + count);
  facings_.resize(kCarried + count);
}

std::size_t PartEdges::next(std::vector<EdgeList>& lists) {
  const std::size_t all = grid_.rows.order.size(), first = read_;
  const std::size_t count = std::min(rows_.size() - kCarried, all - first);
  if (count == 0) return 0;
  if (first > 0) {
    for (std::size_t k = 0; k < kCarried; ++k) {
      std::swap(rows_[k], rows_[rows_.size() - kCarried + k]);
      std::swap(facings_[k], facings_[rows_.size() - kCarried + k]);
    }
  }
  parallel_for(count, [&](std::size_t k) { read(grid_.rows.order[first + k], rows_[kCarried + k]); });
  parallel_for(count, [&](std::size_t k) {
    const std::size_t at = kCarried + k;
    if (first + k > 0) find_facings(rows_[at - 1], rows_[at], first + k, facings_[at]);
  });
  read_ += count;
  if (first == 0 && grid_.rows.begin > 0) strip_beyond_ = facings_[kCarried + grid_.rows.begin];

  // A strip is added once the facings of the next one are known.
  const std::size_t begin = std::max(grid_.rows.begin + 1, std::max<std::size_t>(first, 1) - (first > 0 ? 1 : 0));
  const std::size_t end = read_ == all ? all : read_ - 1;
  lists.resize(end > begin ? end - begin : 0);
  parallel_for(lists.size(), [&](std::size_t k) {
    const std::size_t r = begin + k, at = kCarried + r - first;
    add_strip({rows_[at - 1], rows_[at], facings_[at], r + 1 == all ? no_cells_ : facings_[at + 1], r}, lists[k]);
  });
  return count;
}

void PartEdges::read(std::size_t row, std::vector<Sample>& samples) const {
  const GridAxis &x = grid_.x, &y = grid_.y;
  std::vector<double> z(x.sample_count), other;
  grid_.heights.read_row(y.sample[row], z);
  if (y.fraction[row] > 0) {
    other.resize(z.size());
    grid_.heights.read_row(y.sample[row] + 1, other);
    for (std::size_t i = 0; i < z.size(); ++i) z[i] += (other[i] - z[i]) * y.fraction[row];
  }
  samples.resize(grid_.columns.order.size());
  for (std::size_t c = 0; c < samples.size(); ++c) {
    const std::size_t column = grid_.columns.order[c], i = x.sample[column];
    const double here = x.fraction[column] > 0 ? z[i] + (z[i + 1] - z[i]) * x.fraction[column] : z[i];
    const double height = here * options_.z_scale;
    if (!std::isfinite(height)) {
      samples[c] = Sample{};
      continue;
    }
    samples[c] = eye_.sample(grid_.placed(x.at[column], y.at[row], height));
    if (x.drawn[column] || y.drawn[row]) samples[c] = eye_.placed(samples[c]);
  }
}

/// Facing of the triangle a, b, c, whose corners are counter-clockwise in columns and rows.
std::int8_t PartEdges::facing(const Sample& a, const Sample& b, const Sample& c) const {
  const std::int8_t turned = facing_of(a.seen, b.seen, c.seen, picture_);
  const bool is_same = grid_.columns.sign * grid_.rows.sign * (grid_.transposed ? -1 : 1) > 0;
  return is_same ? turned : static_cast<std::int8_t>(-turned);
}

/// Whether the cell between the positions c - 1, c and r - 1, r is left out.
bool PartEdges::is_left_out(std::size_t c, std::size_t r) const {
  if (!options_.left_out) return false;
  const auto cell = [](const GridAxis& axis, const GridAxis::Part& part, std::size_t k) {
    return std::min(axis.sample[part.order[k - 1]], axis.sample[part.order[k]]);
  };
  const std::size_t i = cell(grid_.x, grid_.columns, c), j = cell(grid_.y, grid_.rows, r);
  const std::size_t columns = (grid_.transposed ? grid_.y : grid_.x).sample_count - 1;
  return (*options_.left_out)[grid_.transposed ? i * columns + j : j * columns + i];
}

void PartEdges::find_facings(const std::vector<Sample>& before, const std::vector<Sample>& row, std::size_t r,
                             std::vector<Facings>& facings) const {
  facings.assign(row.size(), Facings{});
  for (std::size_t c = 1; c < row.size(); ++c) {
    const Sample &n = before[c - 1], &p = before[c], &q = row[c - 1], &f = row[c];
    if (n.hole || p.hole || q.hole || f.hole || is_left_out(c, r)) continue;
    facings[c] = anti_ ? Facings{facing(n, p, q), facing(p, f, q)} : Facings{facing(n, p, f), facing(n, f, q)};
  }
}

/// Adds the strip in front of row r: its cells, its pieces of the columns, and row r; also the part's first row if r is
/// the second.
void PartEdges::add_strip(const Strip& strip, EdgeList& list) {
  list.clear();
  list.of_band.resize(bands_.size());
  list.seen.resize(bands_.size());
  const GridAxis::Part& columns = grid_.columns;
  const bool row_drawn = grid_.y.drawn[grid_.rows.order[strip.r]];
  const std::size_t begin = columns.begin;
  const std::int8_t before_columns = begin > 0 ? far_column(strip.cells[begin]) : before(columns, grid_.x);
  for (std::size_t c = begin; c < strip.row.size(); ++c) {
    CurveTracker* column_curve = grid_.x.drawn[columns.order[c]] ? &column_curves_[c] : nullptr;
    if (c == begin) {
      const std::int8_t behind = c + 1 < strip.row.size() ? near_column(strip.cells[c + 1]) : kNoFace;
      add_edge(list, strip.nearer[c], strip.row[c], {before_columns, behind}, column_curve, begin > 0);
      continue;
    }
    if (strip.r == grid_.rows.begin + 1) add_near_row(strip, c, list);
    add_cell(strip, c, column_curve, row_drawn ? &list.row : nullptr, list);
  }
}

/// Adds the segment of the part's first row in front of cell c.
void PartEdges::add_near_row(const Strip& strip, std::size_t c, EdgeList& list) {
  const std::size_t begin = grid_.rows.begin;
  const bool drawn = grid_.y.drawn[grid_.rows.order[begin]];
  add_edge(list, strip.nearer[c - 1], strip.nearer[c],
           {begin > 0 ? strip_beyond_[c].second : before(grid_.rows, grid_.y), strip.cells[c].first},
           drawn ? &list.nearest_row : nullptr, begin > 0);
}

/// Adds cell c: its contours, its diagonal, and its edges on the far side.
void PartEdges::add_cell(const Strip& strip, std::size_t c, CurveTracker* column_curve, CurveTracker* row_curve,
                         EdgeList& list) const {
  const Facings& cell = strip.cells[c];
  const Sample &n = strip.nearer[c - 1], &p = strip.nearer[c], &q = strip.row[c - 1], &f = strip.row[c];
  const auto far_column_edge = [&] {
    const std::int8_t behind = c + 1 < strip.row.size() ? near_column(strip.cells[c + 1]) : kNoFace;
    add_edge(list, p, f, {far_column(cell), behind}, column_curve);
  };
  const auto contours = [&](const Sample& s, const Sample& t, const Sample& u, std::int8_t facing) {
    if (!levels_.empty()) add_contours(list, s, t, u, facing);
  };
  const auto triangle = [&](const Sample& s, const Sample& t, const Sample& u) {
    if (covers_) add_triangle(list, s, t, u);
  };
  const auto far_row_edge = [&] { add_edge(list, q, f, {cell.second, strip.beyond[c].first}, row_curve); };
  if (!cell.any()) {
    far_column_edge();
    far_row_edge();
  } else if (anti_) {
    contours(n, p, q, cell.first);
    add_edge(list, p, q, {cell.first, cell.second}, nullptr);
    triangle(n, p, q);
    contours(p, f, q, cell.second);
    far_column_edge();
    far_row_edge();
    triangle(p, f, q);
  } else if (first_is_nearer(n, f)) {
    contours(n, p, f, cell.first);
    far_column_edge();  // before the diagonal, which ends in it: this edge may be upright
    add_edge(list, n, f, {cell.first, cell.second}, nullptr);
    triangle(n, p, f);
    contours(n, f, q, cell.second);
    far_row_edge();
    triangle(n, f, q);
  } else {
    contours(n, f, q, cell.second);
    add_edge(list, n, f, {cell.second, cell.first}, nullptr);
    far_row_edge();
    triangle(n, f, q);
    contours(n, p, f, cell.first);
    far_column_edge();
    triangle(n, p, f);
  }
}

/// State in front of the first position of a part, if no position before it is given.
std::int8_t PartEdges::before(const GridAxis::Part& part, const GridAxis& axis) {
  return part.order.front() == 0 || part.order.front() + 1 == axis.at.size() ? kNoFace : kOtherPart;
}

/// Whether lines of sight cross the diagonal n - f from the side of p to the side of q.
bool PartEdges::first_is_nearer(const Sample& n, const Sample& f) const {
  const Camera& camera = view_.camera;
  const Point3 sight = camera.perspective ? n.p - camera.eye : camera.forward, diagonal = f.p - n.p;
  const int column = grid_.transposed ? 1 : 0, row = 1 - column;
  return std::abs(sight[column] * diagonal[row]) <= std::abs(sight[row] * diagonal[column]);
}

/// Adds an edge between its nearer and its farther face; `curve` if it is drawn as part of a curve. An edge straight in
/// front of the eye (`ahead`) belongs to two parts; each part tests its own side.
void PartEdges::add_edge(EdgeList& list, const Sample& a, const Sample& b, Facings faces, CurveTracker* curve,
                         bool ahead) const {
  const auto [nearer, farther] = faces;
  const auto interrupt = [&] {
    if (!curve) return;
    HorizonEdge& end = list.edges.emplace_back();
    end.use = VisibleUse::interruption;
    end.curve = curve;
  };
  if (!is_face(nearer) && !is_face(farther)) return interrupt();
  const bool by_curves = options_.hidden_by == HiddenBy::curves;
  const bool rim = nearer == kNoFace || farther == kNoFace;
  const bool folded = is_face(nearer) && is_face(farther) && nearer != farther;
  const std::int8_t facing = is_face(nearer) ? nearer : farther;
  const bool left_out = curve && facing < 0 && options_.underside == Underside::none && !by_curves;
  const bool outlined = (folded || rim) && (!curve || left_out) && options_.outline;
  bool upper = by_curves && curve, lower = upper && options_.underside != Underside::none;
  if (!covers_ && !by_curves) {
    upper = (!is_face(nearer) || nearer >= 0) && farther != 1;
    lower = (!is_face(nearer) || nearer <= 0) && farther != -1;
  }
  const bool thickens = covers_ && (nearer == 0 || farther == 0);
  if (!curve && !outlined && !upper && !lower && !thickens) return;
  const auto part = eye_.part_in_front(a, b);
  if (!part) return interrupt();
  if (left_out) interrupt();
  const bool tested = (curve && !left_out) || outlined;
  if (tested || upper || lower) {
    HorizonEdge& edge = put(list, *part, upper, lower);
    if (tested) {
      edge.use = VisibleUse::curve;
      if (outlined) edge.use = rim ? VisibleUse::border : VisibleUse::outline;
      if (!outlined && facing < 0 && options_.underside == Underside::apart) edge.use = VisibleUse::underside;
      edge.against = !is_face(nearer) || nearer == 0 ? HorizonSide::both
                     : nearer > 0                    ? HorizonSide::upper
                                                     : HorizonSide::lower;
      if (by_curves) edge.against = lower ? HorizonSide::both : HorizonSide::upper;
      if (by_curves) edge.sides = LineSides::none;
      if (ahead && !by_curves) edge.sides = a.seen.u() > 0 ? LineSides::left : LineSides::right;  // the part is at |u| < 1
      edge.a = placed(list, a);
      edge.b = placed(list, b);
      edge.curve = outlined ? nullptr : curve;
      ++list.tested;
    }
  }
  // The other sides of a triangle seen edge on lie on this line; they are tested before the triangle is added.
  if (thickens) put_triangle(list, {part->a, part->b, part->b});
}

void PartEdges::add_triangle(EdgeList& list, const Sample& a, const Sample& b, const Sample& c) const {
  // The part too near to the vertical through the eye is cut away.
  const std::vector<PlanePoint> contour = eye_.contour_in_front({&a.seen, &b.seen, &c.seen});
  for (std::size_t i = 2; i < contour.size(); ++i) put_triangle(list, {contour[0], contour[i - 1], contour[i]});
}

/// Adds the contour lines in a triangle.
void PartEdges::add_contours(EdgeList& list, const Sample& a, const Sample& b, const Sample& c, std::int8_t facing) const {
  const std::array<const Sample*, 3> corners{&a, &b, &c};
  const auto [low, high] = std::minmax({a.p.z, b.p.z, c.p.z});
  for (auto level = std::upper_bound(levels_.begin(), levels_.end(), low); level != levels_.end() && *level <= high;
       ++level) {
    std::array<Point3, 2> ends;
    int n = 0;
    for (int i = 0; i < 3 && n < 2; ++i) {
      // Interpolates from the lower to the higher end, so that both triangles at an edge find the same point.
      const Sample *s = corners[i], *e = corners[(i + 1) % 3];
      if (s->p.z > e->p.z) std::swap(s, e);
      if (!(s->p.z < *level && *level <= e->p.z)) continue;
      const double t = (*level - s->p.z) / (e->p.z - s->p.z);
      ends[n++] = {s->p.x + t * (e->p.x - s->p.x), s->p.y + t * (e->p.y - s->p.y), *level};
    }
    if (n < 2) continue;
    if (away(ends[1]) < away(ends[0])) std::swap(ends[0], ends[1]);
    const auto number = static_cast<std::size_t>(level - levels_.begin());
    if (options_.contours_on_surface && facing != 0) {
      if (HorizonEdge* edge = add_contour(list, ends, number)) {
        edge->use = VisibleUse::contour;
        edge->against = facing > 0 ? HorizonSide::upper : HorizonSide::lower;
      }
    }
    if (options_.contour_base) {
      // Points below the surface here cannot be visible above nearer ones.
      const double base = *options_.contour_base * options_.z_scale;
      for (Point3& end : ends) end.z = base;
      if (HorizonEdge* edge = add_contour(list, ends, number)) {
        edge->use = VisibleUse::base_contour;
        edge->against = base < *level ? HorizonSide::lower : HorizonSide::upper;
        edge->sides = LineSides::none;
      }
    }
  }
}

/// `ends`: the nearer one first. Null if no part of the segment is in front of the eye.
HorizonEdge* PartEdges::add_contour(EdgeList& list, const std::array<Point3, 2>& ends, std::size_t number) const {
  const Sample &a = list.samples.emplace_back(eye_.placed(eye_.sample(ends[0]))),
               &b = list.samples.emplace_back(eye_.placed(eye_.sample(ends[1])));
  const auto part = eye_.part_in_front(a, b);
  if (!part) return nullptr;
  HorizonEdge& edge = put(list, *part, false, false);
  edge.a = &a;
  edge.b = &b;
  edge.number = static_cast<std::uint32_t>(number);
  return &edge;
}

/// A distance that grows along every line of sight.
double PartEdges::away(const Point3& p) const {
  const int column = grid_.transposed ? 1 : 0;
  return grid_.columns.sign * p[column] + grid_.rows.sign * p[1 - column];
}

void PartEdges::add_back_lines(EdgeList& list) const {
  list.clear();
  list.of_band.resize(bands_.size());
  list.seen.resize(bands_.size());
  for (std::size_t i = 0; i < options_.back_lines.size(); ++i) {
    const auto& line = options_.back_lines[i];
    const Sample a = eye_.sample(line[0]), b = eye_.sample(line[1]);
    double from = 0, to = 1;  // range of the line in this part of the grid
    if (eye_.perspective()) {
      const Point3& eye = view_.camera.eye;
      const std::array<std::array<double, 2>, 2> ahead{
          {{grid_.columns.sign * (a.p.x - eye.x), grid_.columns.sign * (b.p.x - eye.x)},
           {grid_.rows.sign * (a.p.y - eye.y), grid_.rows.sign * (b.p.y - eye.y)}}};
      for (const auto& [da, db] : ahead) {
        if (da < 0 && db < 0) to = -1;
        if (da < 0 && db > 0) from = std::max(from, da / (da - db));
        if (db < 0 && da > 0) to = std::min(to, da / (da - db));
      }
    }
    if (!(from < to)) continue;
    const auto part = eye_.part_in_front(a, b, from, to);
    if (!part) continue;
    HorizonEdge& edge = put(list, *part, false, false);
    edge.a = placed(list, a);
    edge.b = placed(list, b);
    edge.number = static_cast<std::uint32_t>(i);
    edge.use = VisibleUse::back_line;
    if (options_.hidden_by == HiddenBy::curves && options_.underside == Underside::none) edge.against = HorizonSide::upper;
    edge.sides = LineSides::none;
  }
}

/// The sample with its place on the page: itself if it has one, else a copy in the list.
const Sample* PartEdges::placed(EdgeList& list, const Sample& sample) const {
  return sample.placed ? &sample : &list.samples.emplace_back(eye_.placed(sample));
}

/// Adds an edge to the bands that it passes, and if it raises a horizon to the bands that hold its columns; it has no
/// use yet.
HorizonEdge& PartEdges::put(EdgeList& list, const FrontPart& part, bool upper, bool lower) const {
  const auto number = static_cast<std::uint32_t>(list.edges.size());
  HorizonEdge& edge = list.edges.emplace_back();
  edge.line = PlaneSegment(part.a, part.b, upright_);
  edge.from = part.from;
  edge.to = part.to;
  edge.upper = upper;
  edge.lower = lower;
  const Columns& columns = bands_.columns();
  const Line& line = edge.line.line();
  const std::size_t first = columns.at(line.u0), last = edge.line.upright() ? first : columns.at(line.u1);
  edge.first_band = bands_.of_column(first);
  edge.last_band = bands_.of_column(last);
  std::size_t first_band = edge.first_band, last_band = edge.last_band;
  if ((upper || lower) && !edge.line.upright()) {
    const ColumnRange reached = with_neighbours({first, last + 1}, columns);
    first_band = bands_.of_column(reached.begin);
    last_band = bands_.of_column(reached.end - 1);
  }
  for (std::size_t b = first_band; b <= last_band; ++b) list.of_band[b].push_back(number);
  return edge;
}

void PartEdges::put_triangle(EdgeList& list, const PlaneTriangle& triangle) const {
  const auto number = static_cast<std::uint32_t>(list.triangles.size()) | EdgeList::kTriangle;
  const Columns& columns = bands_.columns();
  const auto [low, high] = std::minmax({triangle[0].u(), triangle[1].u(), triangle[2].u()});
  const ColumnRange reached = with_neighbours({columns.at(low), columns.at(high) + 1}, columns);
  for (std::size_t b = bands_.of_column(reached.begin); b <= bands_.of_column(reached.end - 1); ++b)
    list.of_band[b].push_back(number);
  list.triangles.push_back(triangle);
}

}  // namespace ligne::horizon
