#pragma once
/// A depth buffer to which objects can be added later, without painting its faces again.

#include <cstdint>
#include <memory>
#include <utility>

#include "visibility/method.hpp"
#include "visibility/raster/depth_buffer.hpp"

namespace ligne::zbuffer {

class KeptBuffer final : public KeptVisibility {
 public:
  /// `faces`: number of faces of the scene that it was made from; faces with higher numbers are not in it.
  KeptBuffer(DepthBuffer buffer, const View& view, std::uint32_t faces)
      : buffer_(std::move(buffer)), model_to_page_(view.model_to_page), window_(view.window), faces_(faces) {}

  /// Whether faces can be added in this view: the camera and the window must be the same.
  bool fits(const View& view, std::uint32_t faces) const {
    return model_to_page_ == view.model_to_page && window_.min == view.window.min && window_.max == view.window.max &&
           faces_ <= faces;
  }
  const DepthBuffer& buffer() const { return buffer_; }
  std::uint32_t faces() const { return faces_; }

  void write(ByteWriter& bytes) const { buffer_.write(bytes); }
  /// Reads a buffer of `faces` faces in the view. Throws InputError.
  static std::shared_ptr<const KeptBuffer> read(ByteReader& bytes, const View& view, std::uint32_t faces) {
    return std::make_shared<KeptBuffer>(DepthBuffer::read(bytes, view.window, faces), view, faces);
  }

 private:
  DepthBuffer buffer_;
  glm::dmat4 model_to_page_;
  Rect window_;
  std::uint32_t faces_;
};

}  // namespace ligne::zbuffer
