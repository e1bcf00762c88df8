#pragma once
/// Gray pixels in vector files, at their own resolution. Private to plotting.

#include <string>

#include <cairo.h>

#include "drawing/shading.hpp"

namespace ligne {

/// Paints the picture where it lies on the page. Its pixels stay sharp.
void paint_gray(cairo_t* cairo, const GrayPicture& picture, double units_per_mm);

/// The picture as the bytes of a gray PNG.
std::string gray_png(const GrayPicture& picture);

/// Bytes as text of 64 letters, as data URIs have them.
std::string base64(const std::string& bytes);

}  // namespace ligne
