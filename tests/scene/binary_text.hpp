#pragma once
/// Bytes of binary files in words, for tests that are written as text.

#include "support/standard.hpp"

namespace ligne::test {

/// The bytes that a text stands for. It is taken as in scripts, with \n and \xHH, but for its groups <NAME ...>, which may
/// hold others:
///
///     <f8 1 2.5>  <big:u2 7>        numbers: i, u or f and their size in bytes, little endian, or big
///     <zeros N>  <fill N TEXT>      zeros; the text with as many as make it N bytes
///     <head N TEXT>  <cut N TEXT>   the first N bytes; all but the last N
///     <repeat N TEXT>
///     <deflate WINDOW TEXT>         packed, see zip_builder.hpp
///     <zip NAME,NAME TEXT>          an archive of files of this text
///     <chunk4d4d TEXT>              of 3D Studio: a number of two bytes, the size, and the text
///     <block TYPE TEXT>  <element TYPE TEXT>  <matrix NAME ROWS COLUMNS CLASS TEXT>   of MATLAB
///     <npy VERSION TYPE ORDER SHAPE TEXT>                                             of numpy
std::string binary_of(std::string_view text);

}  // namespace ligne::test
