#pragma once
/// A picture in a depth buffer to which objects are added. Earlier objects are not painted again ([Lecture-nd] 5).

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

/// The camera and page of everything in the buffer: those of its first picture.
struct ZBufferPlace {
  Camera camera;
  Rect extent;  ///< area fitted to the page, see projected_extent()
  Page page;
  std::optional<double> scale, unit_mm;  ///< see PageRequest
};

class ZBuffer {
 public:
  /// An empty buffer. The first objects added decide on camera and page.
  ZBuffer() = default;

  /// Adds the objects of a scene, and draws all objects so far. Paints only the new faces into the buffer, but draws
  /// the lines of all objects, since new faces may hide them. The picture equals that of all objects at once. `request`
  /// must use the method zbuffer; after the first call its view and page must be the defaults. Throws like
  /// draw_scene().
  Picture add(Scene scene, const PictureRequest& request, RunReport& run);

  /// All objects, in the order in which they were added.
  const Scene& scene() const { return scene_; }
  /// This scene with the objects of another one appended.
  Scene joined(Scene added) const;
  /// Draws the result of joined().
  Picture draw(Scene joined, PictureRequest request, RunReport& run);

  bool empty() const { return !place_; }

  /// The bytes of a file, see docs/zbuffer-format.md. The buffer must not be empty.
  std::string write() const;
  /// Reads such a file; `name` is for error messages. Throws InputError if the file was changed or cut off, has another
  /// version, or contains no buffer.
  static ZBuffer read(std::span<const std::byte> bytes, const std::string& name);

 private:
  Scene scene_;
  std::optional<ZBufferPlace> place_;
  std::shared_ptr<const zbuffer::KeptBuffer> buffer_;
};

/// Throws RequestError with the option's name if the request sets something of the view or page, which an earlier
/// picture has fixed.
void require_no_place(const PictureRequest& request, const std::string& what);

/// Writes the checksum of all other bytes into the bytes of such a file.
void write_checksum_of_zbuffer(std::string& bytes);

}  // namespace ligne
