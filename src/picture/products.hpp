#pragma once
/// The products of a method that a picture is made of.

#include <cstdint>

#include "picture/requests.hpp"
#include "visibility/method.hpp"

namespace ligne {

/// The method that gives what the picture is made of: the one asked for; else, for fills, hatching and shadows, the first
/// that gives regions; else the default one, in whose place another one may draw the lines (method_choice.hpp).
const Method& method_of(const PictureRequest& request);

/// Whether fills, hatching, shadows or the areas themselves are asked for.
bool asks_for_regions(const PictureRequest& request);

/// Where a method gives regions these are hatched, else its spans.
bool hatches_regions(const PictureRequest& request, const Method& method);

/// Fills are painted from the back to the front, since the method gives an order, and no light casts shadows.
bool paints_in_order(const PictureRequest& request, const Method& method);

/// Products that the picture is made of; a JSON drawing holds all that there are but pixels.
std::uint8_t wanted_products(const PictureRequest& request, const Method& method);

/// The picture needs regions of its method.
bool wants_regions(const PictureRequest& request, const Method& method);

}  // namespace ligne
