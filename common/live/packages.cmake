# Eigen and fmt for Emscripten. /usr/include itself must not be on its include path, because Emscripten has its own C library. So this
# file makes links to their folders.
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
# Eigen sums four numbers in pairs if the processor has SSE2, so the same bits need the same code, which Emscripten translates into
# WebAssembly's vectors. Emscripten has no mmintrin.h, which Eigen includes but does not need. Eigen omits its assembler if the
# compiler identifies itself as neither an old nor a new g++. SSE3 does not change the order of sums, but with only SSE2, clang++ 14
# never finishes compiling a product of quaternions.
file(CONFIGURE OUTPUT ${linked}/mmintrin.h CONTENT "")
add_compile_options(-fexceptions -msimd128 -msse3 -fgnuc-version=5.13.0)
add_link_options(-fexceptions)
# The optimiser of the loader needs acorn, which a node from elsewhere does not find in Debian's folder.
set_property(GLOBAL PROPERTY RULE_LAUNCH_LINK "${CMAKE_COMMAND} -E env NODE_PATH=/usr/share/nodejs")
