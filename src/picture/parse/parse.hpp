#pragma once
/// Converts the texts of options to values, for all front ends.
///
/// Every function takes the whole text of one option and throws std::invalid_argument if it is invalid. what() is a
/// phrase to follow the option's name, such as "200 is not between 0 and 180 degrees".

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/point.hpp"
#include "linework/stroke.hpp"
#include "picture/models/models.hpp"
#include "picture/requests.hpp"
#include "scene/model/scene.hpp"

namespace ligne {

/// A finite number, such as "12", "-0.5", "1e3" or "+2", without other characters.
double parse_number(std::string_view text);

/// A finite number above zero.
double parse_positive(std::string_view text);

/// A number in the open interval (low, high); `unit` is for the message.
double parse_between(std::string_view text, double low, double high, std::string_view unit);

/// A number in the closed interval [low, high].
double parse_within(std::string_view text, double low, double high, std::string_view unit);

/// The parts of a text between separators, of which some may be empty.
std::vector<std::string_view> split(std::string_view text, char separator);

/// A whole number in [low, high].
unsigned parse_count(std::string_view text, unsigned low, unsigned high);

/// "X,Y,Z".
Point3 parse_point(std::string_view text);

/// "X,Y,Z", not all zero.
Point3 parse_vector(std::string_view text);

/// Index of the text among the names.
std::size_t parse_choice(std::string_view text, std::span<const std::string_view> names);

Axis parse_axis(std::string_view text);

/// A comma-separated list of class names; "feature" stands for all except mesh, "all" for all.
LineClasses parse_edges(std::string_view text);

/// "fit" returns nothing, "N:M" returns N / M.
std::optional<double> parse_scale(std::string_view text);

/// Length of a model unit in mm: "mm", "cm", "m", "in", or a number of mm.
double parse_unit_mm(std::string_view text);

/// A comma-separated list of names, as patterns; \ keeps the next character, also a comma.
std::vector<std::string> parse_names(std::string_view text);

/// "NAME=X,Y,Z": model units, or lengths with units (mm, cm, m, in, pt).
PartMove parse_move(std::string_view text);

/// "NAME=COLOUR".
ObjectColor parse_object_color(std::string_view text);

OutputFormat parse_format(std::string_view text);

/// The format that the suffix of the file stands for, in any case.
OutputFormat format_of_suffix(const std::filesystem::path& file);

/// The name of a file, not empty.
std::string parse_file_name(const std::string& text);

/// The names as a phrase, "a, b or c".
std::string list_of(std::span<const std::string_view> names);

}  // namespace ligne
