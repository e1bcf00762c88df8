// Copies of lists: elements that one thread compares and cuts while others work on other lists.

#include <algorithm>
#include <utility>

#include "visibility/newell/paint_elements.hpp"

namespace ligne::newell {
namespace {

/// Replaces the number of each part by its place among the sorted numbers.
void renumber(std::vector<std::uint32_t>& parts, const std::vector<std::uint32_t>& numbers) {
  for (std::uint32_t& part : parts) {
    part = static_cast<std::uint32_t>(std::lower_bound(numbers.begin(), numbers.end(), part) - numbers.begin());
  }
}

std::vector<std::uint32_t> parts_of(const PaintElements& elements, std::span<const std::uint32_t> list) {
  std::vector<std::uint32_t> parts;
  for (const std::uint32_t e : list) parts.insert(parts.end(), elements[e].parts.begin(), elements[e].parts.end());
  std::sort(parts.begin(), parts.end());
  return parts;
}

}  // namespace

PaintElements::PaintElements(const PaintElements& whole, std::span<const std::uint32_t> list)
    : PaintElements(whole, list, parts_of(whole, list)) {}

PaintElements::PaintElements(const PaintElements& whole, std::span<const std::uint32_t> list,
                             std::vector<std::uint32_t> parts)
    : view_(whole.view_),
      scene_(whole.scene_),
      pieces_(whole.pieces_.extract(parts)),
      facts_(whole.facts_),
      face_count_(list.size()),
      volume_(whole.volume_),
      viewpoint_(whole.viewpoint_),
      page_planes_(whole.page_planes_),
      copied_pieces_(std::move(parts)) {
  for (const std::uint32_t piece : copied_pieces_) {
    contours_.push_back({});
    piece_extents_.push_back({});
    copy_contour(whole, piece, contours_.size() - 1);
  }
  copied_points_ = points_.size();
  elements_.reserve(list.size());
  for (const std::uint32_t e : list) copy_element(whole, whole.elements_[e]);
}

/// Appends the contour of a piece and makes it that of a piece of this set.
void PaintElements::copy_contour(const PaintElements& from, std::uint32_t piece, std::size_t to) {
  const std::span<const Point2> contour = from.contour(piece);
  contours_[to] = {points_.size(), points_.size() + contour.size()};
  points_.insert(points_.end(), contour.begin(), contour.end());
  piece_extents_[to] = from.piece_extents_[piece];
}

/// Appends an element of the whole.
void PaintElements::copy_element(const PaintElements& whole, Element element) {
  renumber(element.parts, copied_pieces_);
  if (element.body != kNone) {
    whole_.push_back(whole.whole_[element.body]);
    for (Element& member : whole_.back().members) renumber(member.parts, copied_pieces_);
    element.body = static_cast<std::uint32_t>(whole_.size() - 1);
  }
  const auto corners = whole.element_corners_.begin();
  const auto begin = static_cast<std::ptrdiff_t>(element.corner_begin),
             end = static_cast<std::ptrdiff_t>(element.corner_end);
  element.corner_begin = element_corners_.size();
  element_corners_.insert(element_corners_.end(), corners + begin, corners + end);
  element.corner_end = element_corners_.size();
  elements_.push_back(std::move(element));
}

std::vector<std::uint32_t> PaintElements::take_over(const PaintElements& copy, std::span<const std::uint32_t> list) {
  std::vector<std::uint32_t> numbers(list.begin(), list.end());
  if (copy.size() == list.size()) return numbers;
  const std::vector<std::uint32_t> pieces = pieces_.take_over(copy.pieces_, copy.copied_pieces_);
  contours_.resize(pieces_.pieces().size());
  piece_extents_.resize(contours_.size());
  for (std::uint32_t i = 0; i < copy.contours_.size(); ++i) {
    if (copy.contours_[i][0] >= copy.copied_points_) copy_contour(copy, i, pieces[i]);
  }
  for (std::size_t i = list.size(); i < copy.size(); ++i) {
    Element element = copy.elements_[i];
    for (std::uint32_t& part : element.parts) part = pieces[part];
    numbers.push_back(static_cast<std::uint32_t>(elements_.size()));
    append(std::move(element));
  }
  return numbers;
}

}  // namespace ligne::newell
