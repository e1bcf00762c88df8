#pragma once
/// A depth buffer to which objects can be added: what is in it is not looked at again.

#include <cstdint>
#include <memory>
#include <utility>

#include "visibility/kept_visibility.hpp"
#include "visibility/raster/depth_buffer.hpp"

namespace ligne::zbuffer {

class KeptBuffer final : public KeptVisibility {
 public:
  /// `faces`: of the scene of which it was made; those with higher numbers are not in it.
  KeptBuffer(DepthBuffer buffer, const View& view, std::uint32_t faces)
      : buffer_(std::move(buffer)), model_to_page_(view.model_to_page), window_(view.window), faces_(faces) {}

  /// Nothing else can be added to it than what is seen from the same place.
  bool fits(const View& view, std::uint32_t faces) const {
    return model_to_page_ == view.model_to_page && window_.min == view.window.min && window_.max == view.window.max &&
           faces_ <= faces;
  }
  const DepthBuffer& buffer() const { return buffer_; }
  std::uint32_t faces() const { return faces_; }

  void write(ByteWriter& bytes) const { buffer_.write(bytes); }
  /// Reads the buffer of so many faces in that view. Throws InputError.
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
