#pragma once
/// Moves intersections that run along the rim of a face onto the rim.

#include <optional>
#include <vector>

#include "linework/stroke.hpp"
#include "scene/contacts/chord_errors.hpp"
#include "scene/contacts/face_neighbours.hpp"
#include "scene/heal/edge_tree.hpp"
#include "scene/model/scene.hpp"
#include "view/view.hpp"

namespace ligne {

/// Rims near intersections. Where a pin leaves its bore, its triangles hide parts of the rim of the bore and cut the
/// face around it instead, within the distance of the triangles from the exact shapes. A piece of an intersection this
/// near to a rim is drawn as a piece of the rim. A rim is a border of one of its faces, or an edge that bends by more
/// than `smooth_degrees`.
class RimLines {
 public:
  RimLines(const Scene& scene, const FaceNeighbours& neighbours, const ChordErrors& errors,
           const std::vector<SourceEdge>& segments, double smooth_degrees);

  /// Returns one or two pieces of rims that replace a stroke of an intersection, and appends their sources to
  /// `model.intersections`. Returns none if the stroke runs along no rim, or along a rim whose class is not in
  /// `classes`.
  std::vector<Stroke> pieces(StrokeModel& model, const Stroke& stroke, const View& view, LineClasses classes) const;

 private:
  struct Rim {
    std::uint32_t v0, v1;
    std::uint32_t face, neighbour;
    double distance;  ///< the error of its neighbour: distance of the triangles from the exact shape
  };
  struct Place {
    std::uint32_t rim;
    double at;  ///< 0 at its v0, 1 at its v1
  };
  std::optional<Place> nearest(std::uint32_t face, double distance, const Point3& p) const;
  LineClass line_class(const Rim& rim, const Camera& camera) const;
  /// Adds a piece between two places of one rim.
  void add_piece(StrokeModel& model, std::vector<Stroke>& pieces, const Stroke& stroke, const View& view, const Place& from,
                 double to) const;
  static std::vector<Rim> find_rims(const Scene& scene, const FaceNeighbours& neighbours, const ChordErrors& errors,
                                    const std::vector<SourceEdge>& segments, double smooth_degrees);
  static std::vector<EdgeTree::Segment> places_of(const Scene& scene, const std::vector<Rim>& rims);

  const Scene& scene_;
  const ChordErrors& errors_;
  std::vector<Rim> rims_;
  EdgeTree tree_;
};

}  // namespace ligne
