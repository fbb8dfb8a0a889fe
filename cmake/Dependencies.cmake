# Every library we use, found once. All of them are Debian 12 packages (packages.txt).
find_package(fmt REQUIRED)
find_package(glm REQUIRED)
find_package(Eigen3 REQUIRED NO_MODULE)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(embree 3 REQUIRED)
find_path(TINYOBJLOADER_INCLUDE_DIR tiny_obj_loader.h REQUIRED) # the header alone, compiled for doubles
find_package(Boost REQUIRED COMPONENTS filesystem)
find_package(Threads REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(xxhash REQUIRED IMPORTED_TARGET libxxhash)
# Not OpenImageIOConfig.cmake: Debian's names OpenCV and Python libraries that it does not depend on.
pkg_check_modules(OpenImageIO REQUIRED IMPORTED_TARGET OpenImageIO)
pkg_check_modules(osmesa REQUIRED IMPORTED_TARGET osmesa)
find_path(EGL_INCLUDE_DIR EGL/egl.h REQUIRED)
find_program(GLAD_EXECUTABLE glad REQUIRED HINTS /usr/bin)
