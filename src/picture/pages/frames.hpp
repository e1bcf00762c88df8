#pragma once
/// Successive views of one model, such as the frames of a film or a walk through the model.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "picture/draw_scene.hpp"
#include "picture/pages/write_picture.hpp"

namespace ligne {

struct FrameRequest {
  unsigned count = 1;
  double turn_degrees = 360;  ///< frame i is turned by i / count of this angle
  bool as_pages = false;      ///< PDF: the frames become pages of one document
  /// The path of the eye, a polyline in model space. Frames are at equal distances along it, from its start to its end.
  /// Empty: the model turns.
  std::vector<Point3> eyes{};
  bool looks_ahead = false;  ///< the view direction follows the path; otherwise the eye looks at the target of the view
};

/// Draws the frames and passes each to take(), in order; a document with several pages is passed once. The topology,
/// and what the method compiles, do not depend on the view and are made once. All frames of a rotating model have the
/// same scale and place on the page, so that its axis does not move. The frames of a moving eye have the same field of
/// view, which fills the page. `run` receives the sums of counts and times over all frames, and each warning once.
/// Throws like draw_scene().
void draw_frames(const Scene& scene, PictureRequest request, const FrameRequest& frames, RunReport& run,
                 std::optional<Topology> topology, const std::function<void(Picture)>& take);

/// Names of the files of a drawing in parts, or of successive views.

/// The names of `count` files. One file has `name` itself; otherwise 1, 2, ... replace its placeholder, such as %d or
/// %04d. Throws RequestError of "output" if the name does not have exactly one placeholder.
std::vector<std::string> numbered_names(const std::string& name, unsigned count);

/// Whether a name has a placeholder: %d, or %p for the letter p.
bool has_number_place(const std::string& name, char letter = 'd');

/// The name with the number in place of its placeholder; unchanged if it has none.
std::string with_number(const std::string& name, unsigned number, char letter = 'd');

/// The name of a part of a plot: its number replaces %d, its pen %p.
std::string name_of(const std::string& name, const PicturePart& part);

}  // namespace ligne
