#pragma once
/// Texts of the options of maps, colours and names on surfaces. The functions throw std::invalid_argument.

#include <array>
#include <string>
#include <vector>

#include "picture/surface/surface_request.hpp"

namespace ligne {

/// "none", "index" or "all"; empty: "index".
ContourLabels parse_contour_labels(const std::string& text);
/// A number of contour lines, or 0.
unsigned parse_index_contours(const std::string& text);
/// A height, or "nodata".
void parse_water(const std::string& text, TerrainRequest& terrain);
WaterFill parse_water_fill(const std::string& text);
HachureKind parse_hachures(const std::string& text);
/// "AZIMUTH" or "AZIMUTH:ALTITUDE", degrees.
void parse_sun(const std::string& text, TerrainRequest& terrain);

/// Words separated by commas.
std::vector<std::string> parse_words(const std::string& text);
std::vector<std::array<double, 3>> parse_colors(const std::string& text);
/// "N", "N:even", or heights "Z,Z,...". Throws std::invalid_argument.
void parse_contours(const std::string& text, CurveRequest& curves);

/// A number of bands, or a list of at least two limits.
BandRequest parse_bands(const std::string& text);

}  // namespace ligne
