#pragma once
/// Intersections that run along the rim of a face.

#include <optional>
#include <vector>

#include "linework/stroke.hpp"
#include "scene/contacts/chord_errors.hpp"
#include "scene/contacts/face_neighbours.hpp"
#include "scene/heal/edge_tree.hpp"
#include "scene/model/scene.hpp"
#include "view/view.hpp"

namespace ligne {

/// Where a pin leaves its bore its triangles hide the rim of the bore here and there, and cut the face round it instead,
/// within the distance of the triangles from their shapes. A piece of an intersection that lies so near to a rim (a border
/// of one of its faces, or an edge that bends by more than `smooth_degrees`) is drawn on the rim, as a piece of it.
class RimLines {
 public:
  RimLines(const Scene& scene, const FaceNeighbours& neighbours, const ChordErrors& errors,
           const std::vector<SourceEdge>& segments, double smooth_degrees);

  /// The pieces of rims that stand for a stroke of an intersection, one or two, with sources appended to
  /// `model.intersections`; none where it runs along no rim, or along one of no class of `classes`.
  std::vector<Stroke> pieces(StrokeModel& model, const Stroke& stroke, const View& view, LineClasses classes) const;

 private:
  struct Rim {
    std::uint32_t v0, v1;
    std::uint32_t face, neighbour;
    double distance;  ///< of its two faces' shapes
  };
  struct Place {
    std::uint32_t rim;
    double at;  ///< 0 at its v0, 1 at its v1
  };
  std::optional<Place> nearest(std::uint32_t face, double distance, const Point3& p) const;
  LineClass line_class(const Rim& rim, const Camera& camera) const;
  /// From a place on a rim to another on the same one.
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
