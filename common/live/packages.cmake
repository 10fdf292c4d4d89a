# Eigen, fmt and CLI11 for the compiler of pages. /usr/include itself must not be on its path, which has a C library of its own: links
# lead to their folders.
find_path(EIGEN_FOLDER Eigen/Core PATHS /usr/include/eigen3 /usr/local/include/eigen3 REQUIRED NO_CMAKE_FIND_ROOT_PATH)
find_path(FMT_FOLDER fmt/format.h PATHS /usr/include /usr/local/include REQUIRED NO_CMAKE_FIND_ROOT_PATH)
set(linked ${PROJECT_BINARY_DIR}/others)
file(MAKE_DIRECTORY ${linked})
file(CREATE_LINK ${EIGEN_FOLDER}/Eigen ${linked}/Eigen SYMBOLIC)
file(CREATE_LINK ${FMT_FOLDER}/fmt ${linked}/fmt SYMBOLIC)
add_library(Eigen3::Eigen INTERFACE IMPORTED)
target_include_directories(Eigen3::Eigen INTERFACE ${linked})
add_library(fmt::fmt INTERFACE IMPORTED)
target_compile_definitions(fmt::fmt INTERFACE FMT_HEADER_ONLY)
# Eigen adds up four numbers in pairs where the processor has SSE2, so the same bits need the same code: emscripten translates
# SSE2 into WebAssembly's vectors. It has no mmintrin.h, which Eigen includes and does not need; and Eigen leaves out its
# assembler for compilers that call themselves neither an old nor a new g++. SSE3 adds no other order of sums: with SSE2 alone,
# clang++ 14 never ends compiling a product of quaternions.
file(CONFIGURE OUTPUT ${linked}/mmintrin.h CONTENT "")
add_compile_options(-fexceptions -msimd128 -msse3 -fgnuc-version=5.13.0)
add_link_options(-fexceptions)
# The optimiser of the loader looks for acorn where Debian has it, which a node from elsewhere does not.
set_property(GLOBAL PROPERTY RULE_LAUNCH_LINK "${CMAKE_COMMAND} -E env NODE_PATH=/usr/share/nodejs")
