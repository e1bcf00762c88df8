#include "visibility/atherton_weiler/polygon_clip.hpp"

#include <utility>

#include "geometry/polygons/clip_contour_by_contour.hpp"

namespace ligne::atherton_weiler {

void PolygonClip::divide_general(std::span<const ContourFace> subject, std::span<const ContourFace> clip) {
  ++counts_.general_clips;
  ClipResult parts = clip_contour_by_contour(subject, clip, true, &counts_.signs);
  for (std::vector<ContourFace>* faces : {&parts.inside, &parts.outside}) {
    std::vector<ContourFace>& all = faces == &parts.inside ? inside_ : outside_;
    for (ContourFace& face : *faces) {
      face.is_convex = kind_ == ClipKind::convex && is_convex(face);
      all.push_back(std::move(face));
    }
  }
}

void PolygonClip::divide_convex(const ContourFace& subject, const ContourFace& clip) {
  ++counts_.convex_pairs;
  switch (convex_.meet(subject.contours[0], clip.contours[0])) {
    case ConvexMeeting::apart:
      ++counts_.convex_apart;
      untouched_.push_back(&subject);
      return;
    case ConvexMeeting::within:
      ++counts_.convex_within;
      inside_.push_back(subject);
      return;
    case ConvexMeeting::thin:
      rest_.push_back(subject);
      return;
    case ConvexMeeting::cut:
      break;
  }
  ContourFace& inside = inside_.emplace_back();
  inside.contours.push_back(convex_.inside());
  inside.is_convex = true;
  for (ContourFace& face : convex_.outside()) {
    ++counts_.parts_outside;
    counts_.convex_outside += face.is_convex;
    outside_.push_back(std::move(face));
  }
}

bool PolygonClip::divide(std::span<const ContourFace> subject, std::span<const ContourFace> clip) {
  inside_.clear();
  outside_.clear();
  untouched_.clear();
  if (kind_ == ClipKind::general || clip.size() != 1 || !clip[0].is_convex) {
    divide_general(subject, clip);
    return !inside_.empty();
  }
  rest_.clear();
  const std::uint64_t signs = convex_.signs();
  for (const ContourFace& face : subject) {
    if (face.is_convex) {
      divide_convex(face, clip[0]);
    } else {
      rest_.push_back(face);
    }
  }
  counts_.signs += convex_.signs() - signs;
  if (!rest_.empty()) divide_general(rest_, clip);
  return !inside_.empty();
}

std::vector<ContourFace> PolygonClip::take_outside() {
  for (const ContourFace* face : untouched_) outside_.push_back(*face);
  return std::move(outside_);
}

}  // namespace ligne::atherton_weiler
