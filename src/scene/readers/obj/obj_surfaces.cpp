// A Bezier patch is a B-spline whose end knots are repeated as its degree requires, so one evaluation serves both: the
// basis functions by the recursion of Cox and de Boor (C. de Boor, "A Practical Guide to Splines", 1978, chapter X).

#include "scene/readers/obj/obj_surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "scene/readers/text_lines.hpp"

namespace ligne {
namespace {

/// Number of pieces of a knot span in a curved direction: a quarter turn is then cut every 7.5 degrees.
constexpr std::size_t kSpanPieces = 12;
/// Largest degree that is read: files use 3, and rarely more than 7.
constexpr std::size_t kMostDegree = 24;

std::optional<std::vector<double>> patch_numbers(std::string_view words) {
  std::vector<double> numbers;
  for (std::string_view word = take_word(words); !word.empty(); word = take_word(words)) {
    const std::optional<double> number = number_in(word);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

/// Parameters at which the patch is sampled: the ends of its drawn part, the knots between, and points within their
/// spans.
std::vector<double> patch_parameters(const ObjPatch& patch, std::size_t axis) {
  const std::vector<double>& knots = patch.knots[axis];
  const std::size_t degree = patch.degree[axis];
  const double first = std::max(patch.from[axis], knots[degree]);
  const double last = std::min(patch.to[axis], knots[knots.size() - 1 - degree]);
  std::vector<double> ends{first};
  for (const double knot : knots) {
    if (knot > ends.back() && knot < last) ends.push_back(knot);
  }
  ends.push_back(last);
  std::vector<double> at{first};
  const std::size_t pieces = degree > 1 ? kSpanPieces : 1;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    for (std::size_t k = 1; k < pieces; ++k) {
      at.push_back(ends[i - 1] + (ends[i] - ends[i - 1]) * static_cast<double>(k) / static_cast<double>(pieces));
    }
    at.push_back(ends[i]);
  }
  return at;
}

/// The basis functions that are not zero at a parameter, and the index of the first one.
struct BasisValues {
  std::size_t first = 0;
  std::array<double, kMostDegree + 1> values{};
};

BasisValues basis_at(const std::vector<double>& knots, std::size_t degree, double t) {
  // The last non-empty span that begins at or before t.
  const auto begin = knots.begin() + static_cast<std::ptrdiff_t>(degree),
             end = knots.end() - 1 - static_cast<std::ptrdiff_t>(degree);
  auto after = std::upper_bound(begin, end, t);
  if (after == end) after = std::lower_bound(begin, end, *end);
  const auto span = static_cast<std::size_t>(after - knots.begin()) - 1;
  BasisValues basis;
  basis.first = span - degree;
  basis.values[0] = 1;
  for (std::size_t d = 1; d <= degree; ++d) {
    double carried = 0;
    for (std::size_t k = 0; k < d; ++k) {
      const double right = knots[span + 1 + k], left = knots[span + 1 + k - d];
      const double share = right > left ? basis.values[k] / (right - left) : 0;
      basis.values[k] = carried + (right - t) * share;
      carried = (t - left) * share;
    }
    basis.values[d] = carried;
  }
  return basis;
}

}  // namespace

bool ObjSurfaces::take(std::string_view keyword, std::string_view rest, std::size_t vertex_count, std::string& cause) {
  if (keyword == "cstype") {
    std::string_view word = take_word(rest);
    is_rational_ = word == "rat";
    if (is_rational_) word = take_word(rest);
    basis_ = word == "bezier" ? Basis::bezier : word == "bspline" ? Basis::bspline : Basis::other;
    basis_name_ = word;
  } else if (keyword == "deg") {
    for (std::size_t& degree : degree_) {
      const std::optional<std::int64_t> value = parse_integer(take_word(rest));
      degree = value && *value > 0 ? static_cast<std::size_t>(*value) : 0;
    }
  } else if (keyword == "surf") {
    begin_surface(rest, vertex_count, cause);
  } else if (keyword == "curv" || keyword == "curv2") {
    warnings_.leave_out("curves (" + std::string(keyword) + ")");
  } else if (keyword == "parm") {
    const std::string_view axis = take_word(rest);
    std::optional<std::vector<double>> knots = patch_numbers(rest);
    if (!knots || (axis != "u" && axis != "v")) {
      cause = "parm has a value that is not a number";
    } else if (is_open_) {
      patch_.knots[axis == "v"] = *std::move(knots);
    }
  } else if (keyword == "trim" || keyword == "hole") {
    if (is_open_) warnings_.leave_out("edges of surfaces (" + std::string(keyword) + ")");
  } else if (keyword == "end") {
    if (is_open_) end_surface(cause);
    is_open_ = false;
  } else {
    return keyword == "scrv" || keyword == "sp" || keyword == "con" || keyword == "bmat" || keyword == "step";
  }
  return true;
}

void ObjSurfaces::begin_surface(std::string_view rest, std::size_t vertex_count, std::string& cause) {
  patch_ = {};
  is_open_ = basis_ != Basis::other;
  if (!is_open_) return warnings_.leave_out("surfaces (surf) of cstype " + basis_name_);
  patch_.is_rational = is_rational_;
  patch_.degree = degree_;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const std::optional<double> from = number_in(take_word(rest)), to = number_in(take_word(rest));
    if (!from || !to || !(*from < *to)) {
      cause = "surf without a range of its parameters";
      return;
    }
    patch_.from[axis] = *from;
    patch_.to[axis] = *to;
  }
  const auto count = static_cast<std::int64_t>(vertex_count);
  for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) {
    const std::optional<std::int64_t> written = parse_integer(word.substr(0, word.find('/')));
    const bool relative = written && *written < 0;
    if (!written || *written == 0 || *written > count || (relative && -*written > count)) {
      cause = "surf names vertex " + printable(word) + " of " + std::to_string(count);
      return;
    }
    patch_.control.push_back(static_cast<std::size_t>(relative ? count + *written : *written - 1));
  }
}

void ObjSurfaces::end_surface(std::string& cause) {
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const std::string parm = axis == 0 ? "parm u" : "parm v";
    std::vector<double>& knots = patch_.knots[axis];
    const std::size_t degree = patch_.degree[axis];
    if (degree == 0 || degree > kMostDegree) {
      cause = "surf of a degree that is not 1 to " + std::to_string(kMostDegree);
      return;
    }
    if (basis_ == Basis::bezier && knots.size() >= 2) {
      std::vector<double> repeated{knots.front()};
      for (const double knot : knots) repeated.insert(repeated.end(), degree, knot);
      repeated.push_back(knots.back());
      knots = std::move(repeated);
    }
    if (knots.size() < 2 * (degree + 1)) {
      cause = "surf with too few numbers in its " + parm;
      return;
    }
    const double first = knots[degree], last = knots[knots.size() - 1 - degree];
    if (!std::ranges::is_sorted(knots) || !(first < last) || !std::isfinite(last - first)) {
      cause = "surf whose " + parm + " does not ascend";
      return;
    }
    if (!(patch_.from[axis] < last && patch_.to[axis] > first)) {
      cause = "surf over a range that its " + parm + " does not have";
      return;
    }
  }
  const std::size_t needed = patch_.control_count(0) * patch_.control_count(1);
  if (patch_.control.size() != needed) {
    cause = "surf with " + std::to_string(patch_.control.size()) + " control points, needs " + std::to_string(needed);
    return;
  }
  closed_ = std::move(patch_);
}

std::optional<ObjPatch> ObjSurfaces::closed() { return std::exchange(closed_, std::nullopt); }

PatchGrid sample_patch(const ObjPatch& patch, const std::vector<ObjControlPoint>& control) {
  const std::vector<double> us = patch_parameters(patch, 0), vs = patch_parameters(patch, 1);
  const std::size_t columns = patch.control_count(0);
  std::vector<BasisValues> across;
  across.reserve(us.size());
  for (const double u : us) across.push_back(basis_at(patch.knots[0], patch.degree[0], u));
  PatchGrid grid{us.size(), vs.size(), {}};
  for (const double v : vs) {
    const BasisValues along = basis_at(patch.knots[1], patch.degree[1], v);
    // First the control points of the curve at this v, then the points of that curve.
    std::vector<Point3> row(columns, Point3(0));
    std::vector<double> weights(columns, 0);
    for (std::size_t i = 0; i < columns; ++i) {
      for (std::size_t k = 0; k <= patch.degree[1]; ++k) {
        const ObjControlPoint& point = control[(along.first + k) * columns + i];
        const double weight = along.values[k] * (patch.is_rational ? point.weight : 1);
        row[i] += weight * point.position;
        weights[i] += weight;
      }
    }
    for (const BasisValues& basis : across) {
      Point3 sum(0);
      double weight = 0;
      for (std::size_t k = 0; k <= patch.degree[0]; ++k) {
        sum += basis.values[k] * row[basis.first + k];
        weight += basis.values[k] * weights[basis.first + k];
      }
      grid.points.push_back(patch.is_rational ? sum / weight : sum);
    }
  }
  return grid;
}

}  // namespace ligne
