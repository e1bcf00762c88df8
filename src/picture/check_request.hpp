#pragma once
/// Refusal of requests whose parts do not go together.

#include "picture/requests.hpp"

namespace ligne {

/// Throws RequestError when parts of the request do not go together, or not with the method: gray faces and hatching with
/// the format, hatching and fills with what the method produces, margins with the page.
void check(const PictureRequest& request);

}  // namespace ligne
