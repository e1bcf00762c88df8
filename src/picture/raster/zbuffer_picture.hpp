#pragma once
/// A picture by depth buffer to which objects are added: what is in the buffer is not painted again ([Lecture-nd] 5).

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "picture/pages/write_picture.hpp"
#include "picture/requests.hpp"
#include "picture/run_report.hpp"
#include "scene/model/scene.hpp"
#include "view/view.hpp"

namespace ligne {

namespace zbuffer {
class KeptBuffer;
}

/// From where on what page everything in the buffer is seen: that of its first picture.
struct ZBufferPlace {
  Camera camera;
  Rect extent;  ///< what the page holds, see projected_extent()
  Page page;
  std::optional<double> scale, unit_mm;  ///< see PageRequest
};

class ZBuffer {
 public:
  /// An empty one: what is added first decides from where on what page all is seen.
  ZBuffer() = default;

  /// Adds the objects of a scene, and draws all that were added. Only the faces of this scene are painted into the buffer;
  /// lines are drawn of all objects, since new faces may hide them. The picture is that of all objects at once, from the
  /// same place. `request`: by the method zbuffer; later ones say nothing of view and page. Throws as draw_scene() does.
  Picture add(Scene scene, const PictureRequest& request, RunReport& run);

  /// All objects, in the order in which they were added.
  const Scene& scene() const { return scene_; }
  /// This scene with the parts of another one behind its own.
  Scene joined(Scene added) const;
  /// Draws that.
  Picture draw(Scene joined, PictureRequest request, RunReport& run);

  bool empty() const { return !place_; }

  /// The bytes of a file, see docs/zbuffer-format.md. Not empty.
  std::string write() const;
  /// `name` stands in error messages. Throws InputError for a file that was changed or cut off, is of another version, or
  /// holds no buffer.
  static ZBuffer read(std::span<const std::byte> bytes, const std::string& name);

 private:
  Scene scene_;
  std::optional<ZBufferPlace> place_;
  std::shared_ptr<const zbuffer::KeptBuffer> buffer_;
};

/// Throws RequestError of that field where the request says something of the view or the page, which an earlier picture has
/// decided.
void require_no_place(const PictureRequest& request, const std::string& what);

/// Puts the checksum of the rest into the bytes of such a file.
void sign_zbuffer(std::string& bytes);

}  // namespace ligne
