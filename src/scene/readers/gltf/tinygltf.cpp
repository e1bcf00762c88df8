// The one translation unit that compiles tinygltf. It decodes no images and opens no files (see CMakeLists.txt).

// Its writer, unused here, needs this header, which it does not include if TINYGLTF_NO_FS is set.
#include <fstream>

#define TINYGLTF_IMPLEMENTATION
#include <tiny_gltf.h>
