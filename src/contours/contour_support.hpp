#pragma once
/// Keeps contours close to the outline of the mesh.
///
/// The distance between the smooth surface and the mesh is at most the sag, and so is the distance between their
/// outlines on the page. A contour that is farther away results from wrong normals.

#include <array>
#include <span>
#include <vector>

#include "contours/contour_choice.hpp"

namespace ligne {

/// Whether a point of the page lies in the window of the view.
bool in_window(const View& view, Point2 p);

/// Compares the contours of one group with the outline of the mesh.
class ContourSupport {
 public:
  /// `chains`: the contours of the group; `sides`: the edges of its outline, as sides of the patch.
  ContourSupport(const Scene& scene, const View& view, const SmoothPatch& patch, std::span<ContourChain* const> chains,
                 std::span<const std::uint32_t> sides, double pen_width_mm);

  /// Mean over the nodes of the distance on the page between the point on the mesh and the point on the surface.
  double mean_lift_mm() const { return mean(&Place::lift); }
  /// Mean over the nodes of the sag of the mesh, on the page.
  double mean_sag_mm() const { return mean(&Place::sag); }
  std::size_t nodes() const;
  /// Fraction of the contours' length on the page, 0 to 1, that lies too far from the outline.
  double astray() const;
  /// The contours, with nodes moved to within the sag plus half a pen width of the outline. They end where no outline
  /// lies within reach (a few pen widths), or where the middle of a segment is too far from any. Sets
  /// ContourNode::most_mm and bulge_mm.
  std::vector<ContourChain> supported() const;

 private:
  /// A node on the page.
  struct Place {
    Point2 mm{0, 0}, outline{0, 0};      ///< the node; the nearest point of the mesh's outline
    bool counts = true;                  ///< false outside the window and close to the eye: then it is not compared
    double away = 0, sag = 0, lift = 0;  ///< mm: distance to `outline`; sag; distance from mesh to surface
  };

  Place place_of(const Scene& scene, const ContourNode& node) const;
  /// The midpoints of the chords between nodes, with the sags of their triangles.
  std::vector<Place> middles_of(const ContourChain& chain, const std::vector<Place>& places) const;
  /// Sets Place::outline to the nearest point of the outlines and Place::away to its distance, or to reach() if that is
  /// less.
  void find_outlines(std::span<Place* const> places, std::span<const std::array<Point2, 2>> outlines) const;
  double most_away(const Place& place) const { return place.sag + pen_width_mm_ / 2; }
  double reach(const Place& place) const;
  double mean(double Place::*value) const;

  std::span<ContourChain* const> chains_;
  const SmoothPatch& patch_;
  const View& view_;
  std::vector<std::vector<Place>> places_, middles_;  ///< per chain: the nodes; the midpoints between them
  double pen_width_mm_;
};

}  // namespace ligne
