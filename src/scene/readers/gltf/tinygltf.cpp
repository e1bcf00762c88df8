// The one translation unit that compiles tinygltf. It decodes no images and opens no files (see CMakeLists.txt).

// Its writer, unused here, needs this header, which TINYGLTF_NO_FS makes it forget.
#include <fstream>

#define TINYGLTF_IMPLEMENTATION
#include <tiny_gltf.h>
