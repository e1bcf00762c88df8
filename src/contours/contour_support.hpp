#pragma once
/// Where contours keep to the outline of the mesh.
///
/// The surface lies no farther from the mesh than its sag, so its outline on the page lies no farther from that of the mesh.
/// A contour that leaves it by more comes of normals that have gone astray.

#include <span>
#include <vector>

#include "contours/contour_choice.hpp"

namespace ligne {

/// Whether a point of the page lies in the window of the view.
bool in_window(const View& view, Point2 p);

/// The contours of one group beside the mesh's outline.
class ContourSupport {
 public:
  /// `chains`: of the group, `sides`: the edges of its outline.
  ContourSupport(const Scene& scene, const View& view, const SmoothPatch& patch, std::span<ContourChain* const> chains,
                 std::span<const std::uint32_t> sides, double pen_width_mm);

  /// The mean over the nodes of the way from the mesh to the surface, on the page.
  double mean_lift_mm() const { return mean(&Place::lift); }
  /// The mean over the nodes of the sag of the mesh, on the page.
  double mean_sag_mm() const { return mean(&Place::sag); }
  std::size_t nodes() const;
  /// The share of the contours' length on the page that lies too far from the outline, 0 to 1.
  double astray() const;
  /// The contours, moved to within the sag and half a pen of the outline. They end where no outline is within some widths
  /// of the pen, or where the middle of a segment lies too far from them. Sets ContourNode::most_mm and bulge_mm.
  std::vector<ContourChain> supported() const;

 private:
  /// A node on the page.
  struct Place {
    Point2 mm{0, 0}, outline{0, 0};  ///< outline: its nearest place
    bool counts = true;              ///< it lies in the window, and not right before the eye; others are taken as they are
    double away = 0, sag = 0, lift = 0;  ///< distance from that; sag of the mesh; way from the mesh to the surface; mm
  };

  /// The middles of the chords between places, with the sags of their triangles.
  std::vector<Place> middles_of(const ContourChain& chain, const std::vector<Place>& places) const;
  double most_away(const Place& place) const { return place.sag + pen_width_mm_ / 2; }
  double reach(const Place& place) const;
  double mean(double Place::*value) const;

  std::span<ContourChain* const> chains_;
  const View& view_;
  std::vector<std::vector<Place>> places_, middles_;  ///< of the nodes, and between them
  double pen_width_mm_;
};

}  // namespace ligne
