#include "scene/clean.hpp"
