#pragma once
/// Pictures of faces on Cairo's surfaces. Private to plotting.

#include <cairo.h>

#include "drawing/drawing.hpp"

namespace ligne {

/// Copies the pixels of the picture to an image surface of four bytes a pixel, which must be at least as large.
void put_pixels(cairo_surface_t* surface, const FacePicture& picture);

/// Paints the picture where it lies on the page. Its pixels stay sharp.
void paint_faces(cairo_t* cairo, const FacePicture& picture, double units_per_mm);

}  // namespace ligne
